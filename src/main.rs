//! The command `vides`.

fn main() {}
