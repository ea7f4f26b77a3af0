//! Jobs that can be split by index without changing a bit.

use crate::schema::{Allowed, InvalidInput, Place, Result, Source, read_whole};

/// Checks a part [first, end) of a job that has `count` parts.
pub(super) fn validate_part(field: &str, part: [u32; 2], count: u32) -> Result<[u32; 2]> {
    let [first, end] = part;
    if first <= end && end <= count {
        return Ok(part);
    }
    let expected = format!("[first, end] with 0 ≤ first ≤ end ≤ {count}");
    Err(InvalidInput::new(field, expected, format!("[{first}, {end}]")))
}

/// Reads a part of a job that has `count` parts; all of it if it is left out.
pub(super) fn read_part<S: Source>(given: &S, place: Place<'_>, count: u32) -> Result<[u32; 2]> {
    if !given.is_given() {
        return Ok([0, count]);
    }
    read_whole([0, 0], given, place, &Allowed::whole(0, count))
}
