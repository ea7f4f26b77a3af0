//! The boundary to every other language: a module without imports, to which calls and answers go as bytes of its memory.
//!
//! `reserve(n)` says where there is room for n bytes, until it is asked again. `call(n)` does what the n bytes there ask, a list of
//! a call's name and what is given to it, as `value.rs` has it. It says where the answer is: a byte, how many more there are
//! (u32), and those. The byte is 0 before a value, and 1 before the message with which an input is refused. After a panic, which
//! is a trap, `last_words()` says where its message is, in the same way; the instance must not be called again.

mod value;

mod calls;

use core::cell::RefCell;

use self::calls::Begun;

thread_local! {
    static BEGUN: RefCell<Begun> = const { RefCell::new(Begun::Nothing) };
    static ASKED: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Before a value.
const ANSWERED: u8 = 0;
/// Before the message with which an input is refused, or the core stops.
const REFUSED: u8 = 1;

/// Where there is room for so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    // Where there is no room, what was answered last is no reason.
    say(REFUSED, &[]);
    ASKED.with_borrow_mut(|asked| {
        *asked = vec![0; length];
        asked.as_mut_ptr()
    })
}

/// Does what so many bytes ask, and says where the answer is.
///
/// # Panics
/// If that many were not reserved, or they ask for what there is not.
#[unsafe(no_mangle)]
pub extern "C" fn call(length: usize) -> *const u8 {
    std::panic::set_hook(Box::new(|panic| {
        say(REFUSED, panic.to_string().as_bytes());
    }));
    // What the last call left is no message of a panic.
    say(REFUSED, &[]);
    let answer =
        ASKED.with_borrow(|asked| BEGUN.with_borrow_mut(|begun| begun.answer(&asked[..length])));
    match answer {
        Ok(value) => say(ANSWERED, &value),
        Err(error) => say(REFUSED, error.to_string().as_bytes()),
    }
}

/// Where the message of a panic is.
#[unsafe(no_mangle)]
pub extern "C" fn last_words() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}

fn say(kind: u8, what: &[u8]) -> *const u8 {
    ANSWER.with_borrow_mut(|answer| {
        *answer = [&[kind], &(what.len() as u32).to_le_bytes()[..], what].concat();
        answer.as_ptr()
    })
}
