/*
 * fenderline: contact forces between ships, fenders, quays and tugs, for simulators.
 *
 * Generated from crates/capi by cbindgen: make changes there. docs/guides/c.md shows how to use it.
 *
 * Objects. fl_engine and fl_builder are handles. They are looked up in a table and never dereferenced, so a handle that
 * is NULL, destroyed, of the wrong kind or invalid is refused with a status.
 *
 * Statuses. Every call that can fail returns an fl_status. If it is not FL_STATUS_OK, the call has changed nothing, and
 * an error message is available: from fl_last_error() for the calling thread, from fl_engine_error() and
 * fl_builder_error() for an object. A bug in the library does not unwind into the caller: the status is
 * FL_STATUS_PANICKED, and the object can only be destroyed.
 *
 * Pointers. NULL and misaligned pointers are refused unless stated otherwise. A pointer must point to as much memory as
 * its type, count or length requires; the library cannot check that. For arrays with one element per body, `count` must
 * be the number of bodies.
 *
 * Structures that begin with `size` are refused if it is not their sizeof: fl_settings_init(), fl_body_init() and the like at
 * the end of this file set it, and zero the rest. fl_state, fl_wrench and fl_fender_view have no size member; a change of
 * their layout would change FL_ABI_VERSION.
 *
 * Texts passed in are UTF-8 with a length in bytes; the length FL_NUL means that the text is NUL-terminated. Texts
 * returned are copied to a buffer of `capacity` bytes and NUL-terminated; `*length` gets their length without the NUL. A
 * text that does not fit is truncated, and the status is FL_STATUS_BUFFER_TOO_SMALL. NULL and a capacity of 0 query the
 * length alone.
 *
 * Frame. Earth-fixed north and east, headings clockwise from north, SI units throughout.
 *
 * Threads. Any function may be called from any thread. Calls on different objects run concurrently; of two calls on one
 * object the second waits for the first. An object that is destroyed during a call lives until the call returns. Engines
 * share no state: two in one process give the same bits as each alone.
 */
