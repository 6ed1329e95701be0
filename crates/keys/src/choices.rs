//! Keys whose value is one of several words; each word stands for a value in the program.

use core::any::{Any, type_name};
use core::fmt::Debug;

/// The words that a key may have, each with the value of the program for which the word stands.
#[derive(Debug)]
pub struct Choices<T: 'static>(pub &'static [Choice<T>]);

/// One of the words that a key may have.
#[derive(Debug)]
pub struct Choice<T> {
    /// The word.
    pub word: &'static str,
    /// The value for which the word stands.
    pub value: T,
    /// Meaning of the word, for the user.
    pub doc: &'static str,
}

/// [`Choices`] whose words stand for values of any type, as the table of all keys holds them.
pub trait AnyChoices: Debug + Sync {
    /// The words that the key may have, in the order in which the documentation lists them.
    fn words(&'static self) -> Vec<Word>;
}

/// A [`Choice`] whose word stands for a value of any type.
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
    /// Panics if the word stands for a value of another type than `T`.
    pub fn value<T: Copy + 'static>(&self) -> T {
        match self.value.downcast_ref() {
            Some(value) => *value,
            None => panic!("\"{}\" does not stand for a {}", self.word, type_name::<T>()),
        }
    }
}
