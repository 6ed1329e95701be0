//! The kinds of FMU inputs: what a value that the master sets stands for.

/// What an input of the FMU stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// One component of a body's position or motion.
    State {
        body: usize,
        component: StateComponent,
    },
    /// A body's counter, which the master raises when it puts the body at a new place.
    Placed(usize),
    /// One component of a load on a body.
    Load {
        body: usize,
        component: LoadComponent,
    },
    /// Whether the master controls a vessel; the value is true or false.
    ExternalControl(usize),
    Rudder(usize),
    Engine(usize),
    Thruster(usize, usize),
    AzimuthPower(usize, usize),
    AzimuthDirection(usize, usize),
    /// Whether the master controls a vector tug, a tug that is only a force on a vessel; the value is true or false.
    ExternalTugControl(usize),
    TugForce(usize),
    TugDirection(usize),
    TugPulls(usize),
}

/// A component of a body's earth-fixed position or motion: x is north, y is east.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StateComponent {
    X,
    Y,
    Heading,
    VelocityX,
    VelocityY,
    YawRate,
}

/// A component of an earth-fixed load: x is north, y is east.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LoadComponent {
    X,
    Y,
    Moment,
}
