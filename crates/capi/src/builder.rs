//! Builders of engines.

use core::ffi::c_char;
use core::ptr;

use fenderline_contact::outline::MAX_VERTICES;
use fenderline_contact::vec2;
use fenderline_embed::{BodyDef, EngineBuilder, EngineError, FenderDef};

use crate::border::{
    LONGEST_NAME, LONGEST_PATH, check, put_text, read_all, read_sized, text, write,
};
use crate::engine::{hold, settings_of};
use crate::failure::{FlStatus, failure};
use crate::library::keep_last;
use crate::table::{BUILDERS, FlBuilder, FlEngine, no_panic};
use crate::types::{FlBody, FlFender, FlMaterial, FlSettings};

/// Largest number of points of a reaction curve.
const MOST_POINTS: usize = 10_000;

/// Makes an empty builder at `*builder`, to be destroyed by fl_builder_destroy().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_new(builder: *mut *mut FlBuilder) -> FlStatus {
    no_panic(|| {
        check(builder, "builder")?;
        let made = BUILDERS.insert(EngineBuilder::new())?;
        // SAFETY: as the caller promises.
        unsafe { write(builder, made, "builder") }
    })
}

/// Destroys a builder. Engines that a destroyed builder has built stay valid. A NULL builder is allowed and does
/// nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fl_builder_destroy(builder: *mut FlBuilder) -> FlStatus {
    no_panic(|| if builder.is_null() { Ok(()) } else { BUILDERS.remove(builder) })
}

/// Copies the message of the last failed call on this builder, in the way of fl_last_error().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_error(
    builder: *const FlBuilder,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    keep_last(|_| {
        let own = BUILDERS.error(builder)?;
        // SAFETY: as the caller promises.
        unsafe { put_text(&own, buffer, capacity, length) }
    })
}

/// Adds a material under a unique name. The index of the material, counted from 0, is stored to `*index` unless `index`
/// is NULL. fl_builder_build() checks the material's numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_add_material(
    builder: *mut FlBuilder,
    name: *const c_char,
    name_length: usize,
    material: *const FlMaterial,
    index: *mut u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        // SAFETY: as the caller promises.
        let material = unsafe { read_sized(material, "material") }?;
        check_index(index)?;
        let own = builder.material(&name, material.inward())?;
        // SAFETY: as the caller promises.
        unsafe { write_index(index, own) }
    })
}

/// Adds a body under a unique name, with its outline: `vertices` pairs of x (forward) and y (to starboard) from the
/// centre of gravity (m), in either sense, convex or not. The index of the body, counted from 0, is stored to `*index`
/// unless `index` is NULL. fl_builder_build() checks the body's masses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_add_body(
    builder: *mut FlBuilder,
    name: *const c_char,
    name_length: usize,
    body: *const FlBody,
    outline_m: *const f64,
    vertices: usize,
    index: *mut u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        // SAFETY: as the caller promises.
        let body = unsafe { read_sized(body, "body") }?;
        // SAFETY: as the caller promises.
        let outline_m = unsafe { pairs(outline_m, vertices, MAX_VERTICES, "outline_m") }?;
        let outline_m: Vec<_> = outline_m.into_iter().map(|[x, y]| vec2(x, y)).collect();
        check_index(index)?;
        let own = builder.body(&BodyDef {
            name: &name,
            outline_m: &outline_m,
            mass: body.mass(),
            position_m: vec2(body.north_m, body.east_m),
            heading_rad: body.heading_rad,
        })?;
        // SAFETY: as the caller promises.
        unsafe { write_index(index, own) }
    })
}

/// Adds a fender under a unique name, with its reaction curve: `points` pairs of deflection (m) and reaction (N), which
/// begin with (0, 0), with rising deflections. Without points the force follows the law of the TransNav paper (Moreno
/// et al. 2023): the material's stiffness times the area of the overlap. The index of the fender, counted from 0, is
/// stored to `*index` unless `index` is NULL. fl_builder_build() checks the fender's numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_add_fender(
    builder: *mut FlBuilder,
    name: *const c_char,
    name_length: usize,
    fender: *const FlFender,
    curve: *const f64,
    points: usize,
    index: *mut u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        // SAFETY: as the caller promises.
        let fender = unsafe { read_sized(fender, "fender") }?;
        // SAFETY: as the caller promises.
        let curve = unsafe { pairs(curve, points, MOST_POINTS, "curve") }?;
        check_index(index)?;
        let own = builder.fender(&FenderDef {
            name: &name,
            body: fender.body as usize,
            position_m: fender.position_m(),
            facing_rad: fender.facing_rad,
            width_m: fender.width_m,
            projection_m: fender.projection_m,
            law: FlFender::law(curve),
            unloading: fender.unloading(),
            material: fender.material as usize,
            rated_deflection_m: fender.rated_deflection_m(),
            stop: fender.stop(),
        })?;
        // SAFETY: as the caller promises.
        unsafe { write_index(index, own) }
    })
}

/// Adds a fender under a unique name by the keys of a scenario file's `[fender.NAME]`, one KEY=VALUE per line: a fender
/// of the catalogue by type and size, its temperature, several cones behind one panel, chains. Values carry units. The
/// key `on` names the body that carries the fender, and `material` its material; add body and material before the
/// fender. The key reference of scenario files lists all other keys of a fender. Example of the keys of a fender:
/// "on=quay\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[0, 12]\nwidth=2 m\ntemperature=40 degC". The index
/// of the fender, counted from 0, is stored to `*index` unless `index` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_add_fender_by_keys(
    builder: *mut FlBuilder,
    name: *const c_char,
    name_length: usize,
    keys: *const c_char,
    keys_length: usize,
    index: *mut u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        // SAFETY: as the caller promises.
        let keys = unsafe { text(keys, keys_length, LONGEST_PATH, "keys") }?;
        check_index(index)?;
        let own = builder.fender_by_keys(&name, &keys)?;
        // SAFETY: as the caller promises.
        unsafe { write_index(index, own) }
    })
}

/// Finds the index of a material of a builder by its name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_find_material(
    builder: *const FlBuilder,
    name: *const c_char,
    name_length: usize,
    material: *mut u32,
) -> FlStatus {
    // SAFETY: as the caller promises.
    unsafe { find(builder, name, name_length, material, EngineBuilder::material_named) }
}

/// Finds the index of a body of a builder by its name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_find_body(
    builder: *const FlBuilder,
    name: *const c_char,
    name_length: usize,
    body: *mut u32,
) -> FlStatus {
    // SAFETY: as the caller promises.
    unsafe { find(builder, name, name_length, body, EngineBuilder::body_named) }
}

/// Finds the index of a fender of a builder by its name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_find_fender(
    builder: *const FlBuilder,
    name: *const c_char,
    name_length: usize,
    fender: *mut u32,
) -> FlStatus {
    // SAFETY: as the caller promises.
    unsafe { find(builder, name, name_length, fender, EngineBuilder::fender_named) }
}

/// # Safety
/// The caller's promise.
unsafe fn find(
    builder: *const FlBuilder,
    name: *const c_char,
    name_length: usize,
    index: *mut u32,
    named: impl FnOnce(&EngineBuilder, &str) -> Result<usize, EngineError>,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        check(index, "index")?;
        let own = named(builder, &name)?;
        // SAFETY: as the caller promises.
        unsafe { write_index(index, own) }
    })
}

/// Enables contact between two bodies, with a material.
#[unsafe(no_mangle)]
pub extern "C" fn fl_builder_add_pair(
    builder: *mut FlBuilder,
    body_1: u32,
    body_2: u32,
    material: u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        Ok(builder.pair([body_1 as usize, body_2 as usize], material as usize)?)
    })
}

/// Enables contact between all pairs of bodies that fl_builder_add_pair() does not name, with a material.
#[unsafe(no_mangle)]
pub extern "C" fn fl_builder_add_all_other_pairs(
    builder: *mut FlBuilder,
    material: u32,
) -> FlStatus {
    BUILDERS.call(builder, |builder| Ok(builder.all_other_pairs(material as usize)?))
}

/// Builds an engine from the parts added so far and stores it to `*engine`; if building fails, stores NULL. The program
/// destroys the built engine with fl_engine_destroy() when it no longer needs it. `settings` may be NULL: the engine
/// then has the default settings. The builder stays as it was, and can be used further.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_builder_build(
    builder: *mut FlBuilder,
    settings: *const FlSettings,
    engine: *mut *mut FlEngine,
) -> FlStatus {
    BUILDERS.call(builder, |builder| {
        // SAFETY: as the caller promises.
        unsafe { write(engine, ptr::null_mut(), "engine") }?;
        // SAFETY: as the caller promises.
        let settings = unsafe { settings_of(settings) }?;
        let made = hold(builder.build(&settings)?)?;
        // SAFETY: as the caller promises.
        unsafe { write(engine, made, "engine") }
    })
}

/// Checks the pointer to which a function stores an index; NULL is allowed.
fn check_index(index: *mut u32) -> crate::failure::Outcome {
    if index.is_null() { Ok(()) } else { check(index, "index") }
}

/// # Safety
/// The caller's promise.
unsafe fn write_index(index: *mut u32, own: usize) -> crate::failure::Outcome {
    if index.is_null() {
        return Ok(());
    }
    // SAFETY: as the caller promises.
    unsafe { write(index, own as u32, "index") }
}

/// Copies pairs of numbers from the caller.
///
/// # Safety
/// The caller promises that `count` pairs are readable.
pub(crate) unsafe fn pairs(
    pointer: *const f64,
    count: usize,
    most: usize,
    name: &str,
) -> crate::failure::Outcome<Vec<[f64; 2]>> {
    if count > most {
        let text = format_args!("`{name}` has {count} points; at most {most} are allowed");
        return failure(FlStatus::BadArgument, text);
    }
    let mut numbers = Vec::new();
    // SAFETY: as the caller promises; `count` is within its bound.
    unsafe { read_all(pointer, 2 * count, name, |number| number, &mut numbers) }?;
    Ok(numbers.chunks_exact(2).map(|two| [two[0], two[1]]).collect())
}
