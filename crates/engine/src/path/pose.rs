//! One camera pose, in the layout of the C interface's `V_POSE`.

/// Where the camera is, where it looks, what is up and how far it zooms.
/// The layout is frozen: ten doubles without padding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Pose {
    /// Position (view reference point), world coordinates.
    pub vrp: [f64; 3],
    /// View direction: unit vector along which the camera looks.
    pub vpn: [f64; 3],
    /// Up: unit vector, perpendicular to `vpn`.
    pub vup: [f64; 3],
    /// 1…2000; the vertical field of view is 2·atan(12/zoom).
    pub zoom: f64,
}

impl Pose {
    /// The same memory as plain numbers, ten for each pose.
    pub(super) fn as_numbers(poses: &mut [Self]) -> &mut [f64] {
        const { assert!(size_of::<Pose>() == 10 * size_of::<f64>()) }
        let count = 10 * poses.len();
        // SAFETY: a pose is ten doubles without padding, any bits are a double; the borrow goes on.
        #[allow(unsafe_code)]
        unsafe {
            std::slice::from_raw_parts_mut(poses.as_mut_ptr().cast(), count)
        }
    }
}
