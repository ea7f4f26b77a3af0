//! Jobs that can be split by index without changing a bit.

use crate::schema::{Allowed, InvalidInput, Place, Result, Source, refused};

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
    if given.length(false) != Some(2) {
        return Err(refused(given, place, "an array of 2"));
    }
    let end = |i| {
        let (end, allowed) = (given.element(i), Allowed::whole(0, count));
        let number = end.number().filter(|number| allowed.allows(*number));
        number
            .map(|number| number as u32)
            .ok_or_else(|| refused(&end, Place::Element(&place, i), allowed.expected()))
    };
    Ok([end(0)?, end(1)?])
}
