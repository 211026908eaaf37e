//! The border to C.
