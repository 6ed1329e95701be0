//! Keys that hold one of several words, each of which stands for a value of the program.

use core::any::{Any, type_name};
use core::fmt::Debug;

/// The words of a key, each with the value that it stands for.
#[derive(Debug)]
pub struct Choices<T: 'static>(pub &'static [Choice<T>]);

/// One word of a key.
#[derive(Debug)]
pub struct Choice<T> {
    /// The word.
    pub word: &'static str,
    /// The value for which the word stands.
    pub value: T,
    /// Meaning of the word, for the user.
    pub doc: &'static str,
}

/// [`Choices`] of any type of value, as the key table holds them.
pub trait AnyChoices: Debug + Sync {
    /// The words, in the order in which documentation shows them.
    fn words(&'static self) -> Vec<Word>;
}

/// A [`Choice`] of any type of value.
#[derive(Clone, Copy, Debug)]
pub struct Word {
    /// The word.
    pub word: &'static str,
    /// What the word means.
    pub doc: &'static str,
    value: &'static (dyn Any + Send + Sync),
}

impl<T: Any + Debug + Send + Sync> AnyChoices for Choices<T> {
    fn words(&'static self) -> Vec<Word> {
        self.0.iter().map(|Choice { word, value, doc }| Word { word, doc, value }).collect()
    }
}

impl Word {
    /// The value that the word stands for.
    ///
    /// # Panics
    ///
    /// If the key table has values of another type under this key.
    pub fn value<T: Copy + 'static>(&self) -> T {
        match self.value.downcast_ref() {
            Some(value) => *value,
            None => panic!("\"{}\" does not stand for a {}", self.word, type_name::<T>()),
        }
    }
}
