//! Texts of the window that shows a rotation by quaternions and by Euler angles.

use super::texts;

texts! {
    Compare {
        menu, menu_hint, title, no_keys, of, straight_hint, smooth_hint, quaternions, angles,
        use_these, use_these_of, use_hint, in_use, angle, largest, graph,
    }
}
