//! What the user did to a number; the field itself is [`crate::number`].

/// What the user did to a number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entry<T = f64> {
    Idle,
    /// A drag begins: all up to its end is one step.
    Begin,
    /// The value during a drag.
    Drag(T),
    End,
    /// The drag was cancelled: the value before it is wanted.
    Cancel,
    /// A value was typed.
    Set(T),
    /// Why the typed text is not valid.
    Wrong(String),
}
