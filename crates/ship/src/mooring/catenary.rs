//! The elastic catenary: a cable with weight between two points, suspended or partly on the bottom.

use fenderline_contact::number::greater;

use super::solve::root;

/// A uniform cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cable {
    /// Unstretched length of the cable (m), above 0.
    pub length_m: f64,
    /// EA (N), above 0.
    pub axial_stiffness_n: f64,
    /// Weight of the cable per unstretched length, in water or in air (N/m), above 0.
    pub weight_npm: f64,
}

/// A cable in equilibrium between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Catenary {
    /// Horizontal tension H of the cable, constant along its length, because the bottom has no friction (N).
    pub horizontal_n: f64,
    /// Vertical force of the cable on its upper end, positive downwards (N).
    pub upper_vertical_n: f64,
    /// Vertical force of the cable on its lower end, positive upwards; negative if the cable hangs below the lower end
    /// (N).
    pub lower_vertical_n: f64,
    /// Unstretched length of the cable that lies on the bottom (m).
    pub on_bottom_m: f64,
}

impl Catenary {
    /// Tension of the cable at its upper end (N), the largest in the cable.
    #[must_use]
    pub fn upper_tension_n(&self) -> f64 {
        libm::hypot(self.horizontal_n, self.upper_vertical_n)
    }
}

/// Horizontal extent x and vertical extent z of the cable, with their derivatives with respect to the tensions H
/// (horizontal) and V (vertical).
struct Extent {
    x: f64,
    x_h: f64,
    x_v: f64,
    z: f64,
    z_h: f64,
    z_v: f64,
}

/// Finds the equilibrium of a cable. The upper end of the cable is `span_m` ≥ 0 away horizontally from the lower end
/// and `rise_m` ≥ 0 above it. With `on_bottom`, the lower end of the cable lies on a level bottom without friction.
///
/// The equations of the elastic catenary are x = H/w·[asinh(V/H) − asinh((V−wL)/H)] + HL/EA and z = (√(H²+V²) −
/// √(H²+(V−wL)²))/w + (VL − ½wL²)/EA; with a part L − V/w on the bottom, x = L − V/w + H/w·asinh(V/H) + HL/EA and z =
/// (√(H²+V²) − H)/w + V²/(2EAw) (found: Jonkman's quasi-static module, as MoorPy has it). The equations of the catenary
/// are solved by Newton's method in H and V from Jonkman's first guess. If Newton's method does not converge, two
/// nested one-dimensional problems are solved: V for the rise at each H, and H for the span. Both one-dimensional
/// problems are monotonic, so that bracketed Newton cannot fail.
#[must_use]
pub fn catenary(cable: &Cable, span_m: f64, rise_m: f64, on_bottom: bool) -> Catenary {
    if on_bottom && let Some(slack) = slack_on_bottom(cable, span_m, rise_m) {
        return slack;
    }
    if span_m <= 1e-9 * cable.length_m {
        return vertical(cable, rise_m);
    }
    if on_bottom && rise_m == 0.0 {
        return taut_on_bottom(cable, span_m);
    }
    let weight_n = cable.weight_npm * cable.length_m;
    let (h, v) = newton(cable, span_m, rise_m, on_bottom)
        .unwrap_or_else(|| bracketed(cable, span_m, rise_m, on_bottom));
    let touches_bottom = on_bottom && v < weight_n;
    Catenary {
        horizontal_n: h,
        upper_vertical_n: v,
        lower_vertical_n: if touches_bottom { 0.0 } else { v - weight_n },
        on_bottom_m: if touches_bottom { cable.length_m - v / cable.weight_npm } else { 0.0 },
    }
}

/// Solves for the horizontal and vertical tension H and V of the cable by Newton's method in both; `None` if it does
/// not converge to 1e-12 of the length.
fn newton(cable: &Cable, span_m: f64, rise_m: f64, on_bottom: bool) -> Option<(f64, f64)> {
    let (l, w) = (cable.length_m, cable.weight_npm);
    // λ of the inextensible cable: sinh λ/λ ≈ 1 + λ²/6; 0.2 if the cable is taut (Jonkman, as in MoorPy's Catenary.py).
    let excess = 3.0 * ((l * l - rise_m * rise_m) / (span_m * span_m) - 1.0);
    let lambda = if excess > 0.04 { excess.sqrt() } else { 0.2 };
    let mut h = 0.5 * w * span_m / lambda;
    let mut v = 0.5 * w * (rise_m / libm::tanh(lambda) + l);
    for _ in 0..30 {
        let e = extent(cable, h, v, on_bottom);
        let (x, z) = (span_m - e.x, rise_m - e.z);
        if greater(x.abs(), z.abs()) <= 1e-12 * l {
            return Some((h, v));
        }
        let det = e.x_h * e.z_v - e.x_v * e.z_h;
        let step_h = (x * e.z_v - z * e.x_v) / det;
        let step_v = (z * e.x_h - x * e.z_h) / det;
        // H and V must stay positive.
        h = if h + step_h > 0.0 { h + step_h } else { 0.25 * h };
        v = if v + step_v > 0.0 { v + step_v } else { 0.25 * v };
        if !(h.is_finite() && v.is_finite()) {
            return None;
        }
    }
    None
}

/// Solves for the horizontal and vertical tension H and V by nested bracketed Newton iterations.
fn bracketed(cable: &Cable, span_m: f64, rise_m: f64, on_bottom: bool) -> (f64, f64) {
    let at = |h: f64| {
        let v = vertical_for(cable, h, rise_m, on_bottom);
        let e = extent(cable, h, v, on_bottom);
        let along = if e.z_v > 0.0 { e.x_v * e.z_h / e.z_v } else { 0.0 };
        (e.x - span_m, e.x_h - along)
    };
    let weight_n = cable.weight_npm * cable.length_m;
    let (mut low, mut high) = (weight_n, weight_n);
    while at(low).0 > 0.0 {
        low *= 0.125;
    }
    while at(high).0 < 0.0 {
        high *= 8.0;
    }
    let h = root(at, low, high);
    (h, vertical_for(cable, h, rise_m, on_bottom))
}

/// The equilibrium of a slack cable on the bottom: one part hangs vertically, and the rest lies on the bottom. Returns
/// `None` if the cable is too short to hang vertically.
fn slack_on_bottom(cable: &Cable, span_m: f64, rise_m: f64) -> Option<Catenary> {
    let (w, ea) = (cable.weight_npm, cable.axial_stiffness_n);
    // s + ws²/(2EA) = rise, without cancellation.
    let hanging_m = 2.0 * rise_m / (1.0 + (1.0 + 2.0 * w * rise_m / ea).sqrt());
    (cable.length_m - hanging_m >= span_m).then_some(Catenary {
        horizontal_n: 0.0,
        upper_vertical_n: w * hanging_m,
        lower_vertical_n: 0.0,
        on_bottom_m: cable.length_m - hanging_m,
    })
}

/// The equilibrium of a taut cable that lies wholly on the bottom.
fn taut_on_bottom(cable: &Cable, span_m: f64) -> Catenary {
    let stretch = (span_m - cable.length_m) / cable.length_m;
    Catenary {
        horizontal_n: cable.axial_stiffness_n * stretch,
        upper_vertical_n: 0.0,
        lower_vertical_n: 0.0,
        on_bottom_m: cable.length_m,
    }
}

/// The equilibrium of a cable with one end straight above the other: two vertical legs, or one stretched leg.
fn vertical(cable: &Cable, rise_m: f64) -> Catenary {
    let (l, w, ea) = (cable.length_m, cable.weight_npm, cable.axial_stiffness_n);
    let stretched_m = l + 0.5 * w * l * l / ea;
    let v = if rise_m < stretched_m {
        0.5 * w * (l + rise_m / (1.0 + 0.5 * w * l / ea))
    } else {
        (rise_m - l) * ea / l + 0.5 * w * l
    };
    Catenary {
        horizontal_n: 0.0,
        upper_vertical_n: v,
        lower_vertical_n: v - w * l,
        on_bottom_m: 0.0,
    }
}

/// Vertical tension V at the upper end for a given horizontal tension H and rise.
fn vertical_for(cable: &Cable, h: f64, rise_m: f64, on_bottom: bool) -> f64 {
    let weight_n = cable.weight_npm * cable.length_m;
    let at = |v: f64| {
        let e = extent(cable, h, v, on_bottom);
        (e.z - rise_m, e.z_v)
    };
    let low = if on_bottom { 0.0 } else { 0.5 * weight_n };
    let mut high = weight_n;
    while at(high).0 < 0.0 {
        high *= 8.0;
    }
    root(at, low, high)
}

fn extent(cable: &Cable, h: f64, v: f64, on_bottom: bool) -> Extent {
    let (l, w, ea) = (cable.length_m, cable.weight_npm, cable.axial_stiffness_n);
    let upper = libm::hypot(h, v);
    if on_bottom && v < w * l {
        let rise = libm::asinh(v / h);
        return Extent {
            x: l - v / w + h / w * rise + h * l / ea,
            x_h: (rise - v / upper) / w + l / ea,
            x_v: (h / upper - 1.0) / w,
            z: v * v / (upper + h) / w + 0.5 * v * v / (ea * w),
            z_h: (h / upper - 1.0) / w,
            z_v: v / (upper * w) + v / (ea * w),
        };
    }
    let v2 = v - w * l;
    let lower = libm::hypot(h, v2);
    let turn = libm::asinh(v / h) - libm::asinh(v2 / h);
    Extent {
        x: h / w * turn + h * l / ea,
        x_h: (turn - v / upper + v2 / lower) / w + l / ea,
        x_v: (h / upper - h / lower) / w,
        z: (v - v2) * (v + v2) / (upper + lower) / w + (v * l - 0.5 * w * l * l) / ea,
        z_h: (h / upper - h / lower) / w,
        z_v: (v / upper - v2 / lower) / w + l / ea,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The two solution methods agree wherever both converge, to 1e-6 of the weight. A residual of 1e-12 of the length
    /// is an error of at most EA·1e-12 of tension (here 1e-8 of the weight). It is more for a slack cable, whose shape
    /// depends little on H.
    #[test]
    fn newton_and_the_bracketed_solution_agree() {
        let (mut converged, mut all) = (0, 0);
        for stiffness in [1e2, 1e4] {
            for reach in [0.05, 0.3, 0.7, 0.9, 0.97, 0.99, 0.999, 1.001] {
                for sixteenth in 0..16 {
                    for on_bottom in [false, true] {
                        let slope = f64::from(sixteenth) * 0.098;
                        let weight_npm = 1000.0;
                        let axial_stiffness_n = stiffness * 1e5;
                        let cable = Cable { length_m: 100.0, axial_stiffness_n, weight_npm };
                        let (x, z) =
                            (100.0 * reach * libm::cos(slope), 100.0 * reach * libm::sin(slope));
                        if on_bottom && (z == 0.0 || slack_on_bottom(&cable, x, z).is_some()) {
                            continue;
                        }
                        all += 1;
                        let (h, v) = bracketed(&cable, x, z, on_bottom);
                        let Some((h2, v2)) = newton(&cable, x, z, on_bottom) else { continue };
                        converged += 1;
                        let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * 1e5 + 1e-6 * a.abs();
                        assert!(
                            near(h, h2) && near(v, v2),
                            "{x} {z} {on_bottom}: {h} {h2}, {v} {v2}"
                        );
                    }
                }
            }
        }
        println!("Newton converges in {converged} of {all}");
        assert!(converged * 10 > all * 7, "{converged} of {all}");
    }
}
