//! Numbers, states and contacts as bytes: little-endian, bit for bit.

use fenderline_contact::{
    BodyId, BodyState, Contact, ContactImpulse, ContactWork, EnergyParts, Event, EventKind,
    FenderId, ForceParts, Friction, Panel, PanelMotion, RestoreError, Vec2, Wrench, vec2,
};

use crate::results::{numbers, panel_numbers};

type Read<T> = Result<T, RestoreError>;

/// No fender.
const NONE: u32 = u32::MAX;

#[derive(Default)]
pub(crate) struct Writer(pub(crate) Vec<u8>);

impl Writer {
    pub(crate) fn word32(&mut self, word: u32) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    pub(crate) fn word64(&mut self, word: u64) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    pub(crate) fn numbers(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.word64(number.to_bits()));
    }

    pub(crate) fn state(&mut self, s: &BodyState) {
        let (x, v) = (s.position_m, s.velocity_mps);
        self.numbers(&[x.x, x.y, s.heading_rad, v.x, v.y, s.yaw_rate_radps]);
    }

    pub(crate) fn wrench(&mut self, w: &Wrench) {
        self.numbers(&[w.force_n.x, w.force_n.y, w.moment_nm]);
    }

    pub(crate) fn contact(&mut self, c: &Contact) {
        self.word32(c.body_1.0);
        self.word32(c.body_2.0);
        self.word32(c.fender.map_or(NONE, |fender| fender.0));
        self.word32(c.patch);
        self.word32(u32::from(c.friction == Friction::Slip) + 2 * u32::from(c.limited));
        self.numbers(&numbers(c));
    }

    pub(crate) fn panel(&mut self, p: &PanelMotion) {
        self.word32(p.fender.0);
        self.word32(p.hull.0);
        panel_numbers(p).for_each(|number| self.word64(number.to_bits()));
        p.parted.iter().for_each(|&parted| self.word32(u32::from(parted)));
    }

    pub(crate) fn vector(&mut self, v: Vec2) {
        self.numbers(&[v.x, v.y]);
    }

    pub(crate) fn text(&mut self, text: &str) {
        self.word32(text.len() as u32);
        self.0.extend_from_slice(text.as_bytes());
    }

    pub(crate) fn list<T>(&mut self, of: &[T], write: impl Fn(&mut Self, &T)) {
        self.word32(of.len() as u32);
        of.iter().for_each(|one| write(self, one));
    }

    pub(crate) fn event(&mut self, e: &Event) {
        self.word32(e.bodies[0].0);
        self.word32(e.bodies[1].0);
        let (kind, fender) = match e.kind {
            EventKind::ContactBegan => (0, NONE),
            EventKind::ContactEnded => (1, NONE),
            EventKind::PatchSplit => (2, NONE),
            EventKind::PatchesMerged => (3, NONE),
            EventKind::Contained => (4, NONE),
            EventKind::DeepOverlap => (5, NONE),
            EventKind::Teleported => (6, NONE),
            EventKind::FenderRatingExceeded(fender) => (7, fender.0),
            EventKind::FenderFailed(fender) => (8, fender.0),
            EventKind::NotConverged => (9, NONE),
            EventKind::PlacedInOverlap => (10, NONE),
            EventKind::MassMismatch => (11, NONE),
        };
        self.word32(kind);
        self.word32(fender);
    }
}

pub(crate) struct Reader<'a> {
    pub(crate) rest: &'a [u8],
    pub(crate) bodies: usize,
    pub(crate) fenders: usize,
}

impl<'a> Reader<'a> {
    pub(crate) fn take(&mut self, count: usize) -> Read<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or(RestoreError::Length)?;
        self.rest = rest;
        Ok(taken)
    }

    pub(crate) fn word32(&mut self) -> Read<u32> {
        let bytes = self.take(4)?.try_into().map_err(|_| RestoreError::Length)?;
        Ok(u32::from_le_bytes(bytes))
    }

    pub(crate) fn word64(&mut self) -> Read<u64> {
        let bytes = self.take(8)?.try_into().map_err(|_| RestoreError::Length)?;
        Ok(u64::from_le_bytes(bytes))
    }

    /// Reads a word that must be 0 or 1.
    pub(crate) fn flag(&mut self) -> Read<bool> {
        match self.word32()? {
            0 => Ok(false),
            1 => Ok(true),
            _ => Err(RestoreError::Content),
        }
    }

    pub(crate) fn number(&mut self) -> Read<f64> {
        let value = f64::from_bits(self.word64()?);
        if value.is_finite() { Ok(value) } else { Err(RestoreError::Content) }
    }

    pub(crate) fn numbers<const N: usize>(&mut self) -> Read<[f64; N]> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Ok(numbers)
    }

    pub(crate) fn vector(&mut self) -> Read<Vec2> {
        let [x, y] = self.numbers()?;
        Ok(vec2(x, y))
    }

    pub(crate) fn state(&mut self) -> Read<BodyState> {
        let [north_m, east_m, heading_rad, north_mps, east_mps, yaw_rate_radps] = self.numbers()?;
        Ok(BodyState {
            position_m: vec2(north_m, east_m),
            heading_rad,
            velocity_mps: vec2(north_mps, east_mps),
            yaw_rate_radps,
        })
    }

    pub(crate) fn wrench(&mut self) -> Read<Wrench> {
        let [north_n, east_n, moment_nm] = self.numbers()?;
        Ok(Wrench { force_n: vec2(north_n, east_n), moment_nm })
    }

    /// Reads a list of as many items as the bytes say, but never more items than the remaining bytes can hold.
    pub(crate) fn list<T>(&mut self, read: impl Fn(&mut Self) -> Read<T>) -> Read<Vec<T>> {
        let count = self.word32()?;
        (0..count).map(|_| read(self)).collect()
    }

    pub(crate) fn text(&mut self) -> Read<String> {
        let length = self.word32()? as usize;
        let bytes = self.take(length)?;
        str::from_utf8(bytes).map(str::to_owned).map_err(|_| RestoreError::Content)
    }

    pub(crate) fn panel(&mut self) -> Read<PanelMotion> {
        let fender = self.fender()?.ok_or(RestoreError::Content)?;
        let hull = self.body()?;
        let [deflection_m, tilt_rad, moment_nm, peak_tilt_rad, peak_moment_nm] = self.numbers()?;
        let (peak_deflections_m, least_deflections_m) = (self.numbers()?, self.numbers()?);
        let peak_tensions_n = self.numbers()?;
        let mut parted = [false; Panel::MOST_CHAINS];
        for one in &mut parted {
            *one = self.flag()?;
        }
        Ok(PanelMotion {
            fender,
            hull,
            deflection_m,
            tilt_rad,
            moment_nm,
            peak_tilt_rad,
            peak_moment_nm,
            peak_deflections_m,
            least_deflections_m,
            peak_tensions_n,
            parted,
        })
    }

    pub(crate) fn body(&mut self) -> Read<BodyId> {
        let body = self.word32()?;
        if (body as usize) < self.bodies { Ok(BodyId(body)) } else { Err(RestoreError::Content) }
    }

    fn fender(&mut self) -> Read<Option<FenderId>> {
        match self.word32()? {
            NONE => Ok(None),
            fender if (fender as usize) < self.fenders => Ok(Some(FenderId(fender))),
            _ => Err(RestoreError::Content),
        }
    }

    pub(crate) fn contact(&mut self) -> Read<Contact> {
        let (body_1, body_2, fender) = (self.body()?, self.body()?, self.fender()?);
        let (patch, flags) = (self.word32()?, self.word32()?);
        if flags > 3 {
            return Err(RestoreError::Content);
        }
        let [point_m, arm_1_m] = [self.vector()?, self.vector()?];
        let [arm_2_m, normal] = [self.vector()?, self.vector()?];
        let [area_m2, depth_m, v_normal_mps, v_tangential_mps, shear_m] = self.numbers()?;
        let [normal_force_n, tangential_force_n] = self.numbers()?;
        let [normal_ns, tangential_ns] = self.numbers()?;
        let [peak_normal_force_n, peak_depth_m] = self.numbers()?;
        let [spring_n, stop_n, damper_n, limiter_n] = self.numbers()?;
        let [normal_j, tangential_j, damper_j, limiter_j] = self.numbers()?;
        let [factor, tilt_rad, stored_j, peak_absorbed_j, shear_stored_j] = self.numbers()?;
        let [hysteresis_j, hysteresis_at_start_j] = self.numbers()?;
        Ok(Contact {
            body_1,
            body_2,
            fender,
            patch,
            area_m2,
            depth_m,
            point_m,
            arm_1_m,
            arm_2_m,
            normal,
            v_normal_mps,
            v_tangential_mps,
            shear_m,
            normal_force_n,
            tangential_force_n,
            impulse: ContactImpulse { normal_ns, tangential_ns },
            friction: if flags & 1 == 1 { Friction::Slip } else { Friction::Stick },
            limited: flags & 2 == 2,
            peak_normal_force_n,
            peak_depth_m,
            parts: ForceParts { spring_n, stop_n, damper_n, limiter_n },
            work: ContactWork { normal_j, tangential_j, damper_j, limiter_j },
            factor,
            tilt_rad,
            energy: EnergyParts {
                stored_j,
                peak_absorbed_j,
                hysteresis_j,
                hysteresis_at_start_j,
                shear_stored_j,
            },
        })
    }

    pub(crate) fn event(&mut self) -> Read<Event> {
        let bodies = [self.body()?, self.body()?];
        let (kind, fender) = (self.word32()?, self.fender()?);
        let kind = match (kind, fender) {
            (0, None) => EventKind::ContactBegan,
            (1, None) => EventKind::ContactEnded,
            (2, None) => EventKind::PatchSplit,
            (3, None) => EventKind::PatchesMerged,
            (4, None) => EventKind::Contained,
            (5, None) => EventKind::DeepOverlap,
            (6, None) => EventKind::Teleported,
            (7, Some(fender)) => EventKind::FenderRatingExceeded(fender),
            (8, Some(fender)) => EventKind::FenderFailed(fender),
            (9, None) => EventKind::NotConverged,
            (10, None) => EventKind::PlacedInOverlap,
            (11, None) => EventKind::MassMismatch,
            _ => return Err(RestoreError::Content),
        };
        Ok(Event { bodies, kind })
    }
}
