//! `fenderline fender fit`: from rows to a fender that a scenario takes.

use crate::support;

use support::{BERTH, Workplace, contains_all};

/// A softening curve to 0.6 m, 61 rows.
fn rows() -> String {
    let row = |i: u32| {
        let m = f64::from(i) * 0.01;
        format!("{m:.2},{:.4}\n", 1200.0 * m / (m + 0.2))
    };
    format!("# from a bench\ndeflection_m,reaction_kn\n{}", (0..=60).map(row).collect::<String>())
}

#[test]
fn a_fitted_fender_is_taken_by_a_scenario() {
    let place = Workplace::new("fender_fit");
    place.write("bench.csv", rows().as_bytes());
    let fit = place.run(&[
        "fender",
        "fit",
        "bench.csv",
        "-o",
        "bench.toml",
        "--height",
        "1",
        "--length",
        "2",
        "--source",
        "the bench",
        "--plot",
        "bench.html",
    ]);
    assert_eq!(fit.code, 0, "{}", fit.stderr);
    contains_all(&fit.stdout, &["rated: 600.0 mm, 900.00 kN", "for 61 rows", "bench.toml"]);
    let toml = place.text("bench.toml");
    contains_all(
        &toml,
        &["[family.\"bench\"]", "source = \"the bench\"", "standing = \"derived\""],
    );
    contains_all(&place.text("bench.html"), &["<svg", "measured", "fitted"]);
    let scenario = BERTH.replace("title =", "fender_files = [\"bench.toml\"]\ntitle =").replace(
        "type = \"cone\"\nheight = \"2 m\"\nrated_reaction = \"3500 kN\"",
        "type = \"bench\"\nsize = \"bench\"\ncount = 4",
    );
    place.write("berth.toml", scenario.as_bytes());
    // The ship passes the fender and strikes the quay, which is a failure of the berth, not of the fender file.
    let run = place.run(&["run", "berth.toml", "--allow-failures"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
}

/// The generic curve of a catalogue, in per cent of height and rated reaction, and the table's rated reaction.
#[test]
fn a_catalogue_s_percentages_become_a_fender_and_options_take_units() {
    let place = Workplace::new("fender_fit_percent");
    let rows = "deflection_percent,reaction_percent\n5,20\n10,39\n20,76\n35,100\n55,88\n65,90\n72,100\n75,110\n";
    place.write("page.csv", rows.as_bytes());
    let start = ["fender", "fit", "page.csv", "-o", "our.toml", "--height", "1.2 m"];
    let fit = |more: &[&str]| place.run(&[&start, more].concat());
    let good = ["--rated-reaction", "585 kN", "--rated-deflection", "72 %", "--tolerance", "0.1 %"];
    let run = fit(&good);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["rated: 864.0 mm, 585.00 kN"]);
    contains_all(&place.text("our.toml"), &["rated_deflection = 0.72", "reaction = \"585000 N\""]);
    let refused = |more: &[&str], fragments: &[&str]| {
        let run = fit(more);
        assert_eq!(run.code, 2, "{}", run.stdout);
        contains_all(&run.stderr, fragments);
    };
    refused(
        &["--rated-reaction", "585 kN"],
        &["at the end of the curve, 900 mm", "110 %", "--rated-deflection \"864 mm\""],
    );
    refused(&[], &["page.csv:1", "`reaction_percent`", "--rated-reaction \"585 kN\""]);
    refused(&["--rated-reaction", "60 t"], &["a mass [kg], but must be a force [N]"]);
    let newtons = fit(&["--rated-reaction", "585", "--rated-deflection", "72 %"]);
    contains_all(
        &newtons.stderr,
        &["0.585 kN at a height of 1.2 m", "\"585 kN\" in place of 585 N?"],
    );
}

#[test]
fn bad_curves_and_options_are_errors_and_write_nothing() {
    let place = Workplace::new("fender_fit_bad");
    place.write("bench.csv", rows().as_bytes());
    place.write("negative.csv", b"deflection_m,reaction_kn\n0.1,5\n0.2,-1\n");
    let fit = |file: &str, more: &[&str]| {
        let run = place.run(&[&["fender", "fit", file, "-o", "out.toml"], more].concat());
        assert_eq!(run.code, 2, "{}", run.stderr);
        assert!(!place.path("out.toml").exists());
        run.stderr
    };
    contains_all(
        &fit("negative.csv", &["--height", "1"]),
        &["negative.csv:3:5", "`reaction_kn`", "-1"],
    );
    contains_all(
        &fit("bench.csv", &["--height", "0.5"]),
        &["bench.csv", "ends at a deflection of 0.6 m", "0.5 m high"],
    );
    contains_all(
        &fit("bench.csv", &["--height", "1", "--returned-energy", "120 %"]),
        &["the returned energy is 1.2", "between 0.05 and 1"],
    );
    contains_all(
        &fit("bench.csv", &["--height", "1", "--family", "cone"]),
        &["there is a family named \"cone\" already"],
    );
    contains_all(&fit("nowhere.csv", &["--height", "1"]), &["cannot read", "nowhere.csv"]);
}
