//! The boundary to every other language: a module without imports, to which calls and answers go as bytes of its memory.
//!
//! `reserve(n)` says where to write the n bytes of a call: a list of its name and what is given to it, as `value.rs` has it. `call()`
//! gives 0 where it is answered, and 1 where an input is refused and the answer is the message. `answer()` and
//! `answer_length()` say where the answer is. After a panic, which is a trap, it is the panic's message, and the instance must
//! not be called again.

mod value;

mod calls;

use core::cell::RefCell;

use self::calls::Begun;

thread_local! {
    static BEGUN: RefCell<Begun> = const { RefCell::new(Begun::Nothing) };
    static ASKED: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a call of so many bytes, and says where.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    ASKED.with_borrow_mut(|asked| {
        *asked = vec![0; length];
        asked.as_mut_ptr()
    })
}

/// Does what is asked: 0 if it is answered, 1 if it is refused.
#[unsafe(no_mangle)]
pub extern "C" fn call() -> u32 {
    std::panic::set_hook(Box::new(|panic| ANSWER.set(panic.to_string().into_bytes())));
    ANSWER.take();
    let asked = ASKED.take();
    let answer = BEGUN.with_borrow_mut(|begun| begun.answer(&asked));
    let refused = u32::from(answer.is_err());
    ANSWER.set(answer.unwrap_or_else(|error| error.to_string().into_bytes()));
    refused
}

/// Where the last answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}

/// How many bytes it has.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    ANSWER.with_borrow(Vec::len)
}
