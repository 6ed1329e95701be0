/*
 * fenderline: contact forces between ships, fenders, quays and tugs, for simulators.
 *
 * Made from crates/capi by cbindgen: change it there. docs/guides/c.md shows how it is used.
 *
 * Objects. fl_engine and fl_builder are handles: they are looked up in a table and never followed, so that one
 * that is NULL, was destroyed, is of the other kind or never was a handle is refused with a status.
 *
 * Statuses. Every call that can fail returns an fl_status. Anything but FL_STATUS_OK has changed nothing, and
 * leaves a text for people: fl_last_error() for the calling thread, fl_engine_error() and fl_builder_error()
 * for an object. No fault of the library unwinds into the caller: it is FL_STATUS_PANICKED, and the object
 * can only be destroyed.
 *
 * Pointers. NULL and pointers that are not aligned are refused where not said otherwise. A pointer must point
 * to as much memory as its type, count or length says: no library can check that. Arrays that have one
 * member a body are refused, before they are read, where `count` is another number.
 *
 * Structures that begin with `size` are refused where that is not sizeof: set it, and zero the rest. fl_state
 * and fl_wrench are as they are; a change of them would change FL_ABI_VERSION.
 *
 * Texts that are given are UTF-8 and have a length in bytes; FL_NUL for the length says that they end with a
 * NUL. Texts that are asked for go to a buffer of `capacity` bytes with a NUL behind them; `*length` gets
 * their length without it. A text that does not fit is cut, and the status is FL_STATUS_BUFFER_TOO_SMALL.
 * NULL and a capacity of 0 ask for the length alone.
 *
 * Frame. Earth-fixed north and east, headings clockwise from north, SI units throughout.
 *
 * Threads. Any function may be called from any thread. Calls on different objects run at the same time; of two
 * calls on one object the second waits for the first. An object that is destroyed while a call on it runs
 * ends with that call. Engines share nothing: two in one process give the bits that each would alone.
 */
