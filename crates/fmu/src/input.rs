//! What an input stands for.

/// What an input stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// A component of a body's state.
    State {
        body: usize,
        component: StateComponent,
    },
    /// A body's counter of repositionings.
    Placed(usize),
    /// A component of a load on a body.
    Load {
        body: usize,
        component: LoadComponent,
    },
    /// True where the master controls a vessel.
    ExternalControl(usize),
    Rudder(usize),
    Engine(usize),
    Thruster(usize, usize),
    AzimuthPower(usize, usize),
    AzimuthDirection(usize, usize),
    /// True where the master controls a vector tug.
    ExternalTugControl(usize),
    TugForce(usize),
    TugDirection(usize),
    TugPulls(usize),
}

/// Earth-fixed: x is north, y is east.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StateComponent {
    X,
    Y,
    Heading,
    VelocityX,
    VelocityY,
    YawRate,
}

/// Earth-fixed: x is north, y is east.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LoadComponent {
    X,
    Y,
    Moment,
}
