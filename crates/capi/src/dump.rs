//! Recorded steps of an engine, and dumps of them, which replay to the same bits.

use core::ptr;

use fenderline_embed::Dump;

use crate::border::{bytes, check, put_bytes, write};
use crate::engine::hold;
use crate::failure::FlStatus;
use crate::table::{ENGINES, FlEngine, no_panic};

/// Records the engine's steps from now on, and keeps at least the last `steps` steps (at most 1 000 000); `steps` = 0
/// ends the recording. A step takes longer while the engine records.
#[unsafe(no_mangle)]
pub extern "C" fn fl_engine_record(engine: *mut FlEngine, steps: usize) -> FlStatus {
    ENGINES.call(engine, |held| Ok(held.engine.record(steps)?))
}

/// Copies the recorded steps with all that is needed to replay them: model, settings, and the engine before the first
/// recorded step. fl_engine_dump() also works after a failed step, even after FL_STATUS_PANICKED. Write the bytes of
/// the dump to a file and send the file with your report of a bug: `fenderline replay FILE` takes the same steps. A
/// NULL buffer with a capacity of 0 only asks for the length of the dump, in `*length`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_dump(
    engine: *const FlEngine,
    buffer: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    ENGINES.call_even_panicked(engine, |held| {
        let dump = held.engine.dump()?;
        // SAFETY: as the caller promises.
        unsafe { put_bytes(&dump, buffer, capacity, length) }
    })
}

/// Replays a dump: makes an engine, takes the recorded steps and stores the engine after the last step to `*engine`,
/// unless `engine` is NULL. `*different` gets the number of replayed steps that did not end as recorded, bit for bit;
/// it is 0 with the same version of the library. `*steps` gets the number of all steps in the dump. The pointers
/// `different` and `steps` may be NULL. The `dump` may consist of any bytes: the call refuses bytes that are not a
/// dump.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_replay_dump(
    dump: *const u8,
    length: usize,
    steps: *mut usize,
    different: *mut usize,
    engine: *mut *mut FlEngine,
) -> FlStatus {
    no_panic(|| {
        if !engine.is_null() {
            // SAFETY: as the caller promises.
            unsafe { write(engine, ptr::null_mut(), "engine") }?;
        }
        for count in [steps, different] {
            if !count.is_null() {
                check(count, "count")?;
            }
        }
        // SAFETY: as the caller promises.
        let mut dump = Dump::read(&unsafe { bytes(dump, length, "dump") }?)?;
        let (all, mut others) = (dump.steps(), 0);
        while let Some(step) = dump.next_step() {
            others += usize::from(!step.is_same);
        }
        for (count, value) in [(steps, all), (different, others)] {
            if !count.is_null() {
                // SAFETY: as the caller promises.
                unsafe { write(count, value, "count") }?;
            }
        }
        if !engine.is_null() {
            // SAFETY: as the caller promises.
            unsafe { write(engine, hold(dump.into_engine())?, "engine") }?;
        }
        Ok(())
    })
}
