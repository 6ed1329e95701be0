//! A made-up passage between two coasts, over a survey: a small form of the passage that `cargo xtask bench passage`
//! measures.

use fenderline_sim::Simulation;

use crate::made_up_passage::{Size, sail};

const SMALL: Size = Size { nodes: [420, 201], cell_m: 10.0, corners: 600, legs: 2 };

#[test]
fn a_ship_sails_a_made_up_passage_in_its_corridor_with_the_same_bits_twice() {
    let files = SMALL.files();
    let ends = [(); 2].map(|()| {
        let setup = files.read().unwrap_or_else(|error| panic!("{error}")).setup;
        let world = &setup.world;
        let field = &world.environment.bottom.as_ref().expect("a bottom by place").field;
        assert_eq!(field.nodes(), [201, 420], "north and east");
        assert!(world.environment.squat.is_some());
        let shore = setup.bodies.iter().find(|body| body.name == "shore").expect("a solid shore");
        assert!(shore.outline.is_of_parts());
        let half_width_m = world.vessels[0].plan.as_ref().unwrap().waypoints()[1].half_width_m;
        let mut simulation = Simulation::new(setup).unwrap();
        let sailed = sail(&mut simulation, 20_000);
        let plan = simulation.setup().world.vessels[0].plan.as_ref().unwrap();
        assert!(sailed.along_m >= plan.length_m(), "{sailed:?}");
        assert!(Some(sailed.off_m) < half_width_m, "{sailed:?}");
        // Over the level bottom of the channel all the way: 14.5 m and 0.5 m of tide.
        assert!((sailed.least_m - 15.0).abs() < 1e-6, "{sailed:?}");
        assert!(simulation.vessels()[0].squat_m > 0.2);
        simulation.states().to_vec()
    });
    assert_eq!(ends[0], ends[1]);
}
