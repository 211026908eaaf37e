//! How others lay out cameras, angles, times and axes; converted here and nowhere else.
//!
//! Ours: right-handed, y or z up, the camera looks along its view with its up; its quaternion
//! takes (0, 0, 1) to the view and (0, 1, 0) to up.

use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use vides_engine::limits::{MAX_ZOOM, MIN_ZOOM};
use vides_engine::math::camera::CameraAxes;
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::math::quaternion::continue_sign;
use vides_engine::path::{Pose, Up};

use super::error::{Cause, Place, Result, Wanted};

/// The height of the film in mm (36 × 24 mm).
pub const FILM_HEIGHT: f64 = 24.0;

const HALF_FILM: f64 = 0.5 * FILM_HEIGHT;

/// A matrix whose columns are farther than this from perpendicular unit vectors is no rotation.
/// Files hold six digits, and some programs let rounding grow.
const NEARLY: f64 = 1e-2;

/// Half a turn about up: what looks along z looks along −z then, and back. (0, 0, 1, 0) as w x y z.
pub const HALF_TURN: DQuat = DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0);

/// The vertical field of view of a zoom, in radians.
#[must_use]
pub fn field_of_view(zoom: f64) -> f64 {
    2.0 * (HALF_FILM / zoom).atan()
}

/// The zoom of a vertical field of view in radians, and whether it lies in the range; one beyond it
/// is clamped.
#[must_use]
pub fn zoom_of_field(radians: f64) -> (f64, bool) {
    within(HALF_FILM / (0.5 * radians).tan())
}

/// The focal length in pixels of a zoom, for a picture of this height in pixels.
#[must_use]
pub fn focal_pixels(zoom: f64, height: f64) -> f64 {
    zoom * height / (2.0 * HALF_FILM)
}

/// The zoom of a focal length in pixels; see [`zoom_of_field`].
#[must_use]
pub fn zoom_of_focal(pixels: f64, height: f64) -> (f64, bool) {
    within(pixels * 2.0 * HALF_FILM / height)
}

/// The focal length in pixels of a horizontal field of view in radians.
#[must_use]
pub fn focal_of_width(radians: f64, width: f64) -> f64 {
    0.5 * width / (0.5 * radians).tan()
}

/// The horizontal field of view in radians of a focal length in pixels.
#[must_use]
pub fn width_of_focal(pixels: f64, width: f64) -> f64 {
    2.0 * (0.5 * width / pixels).atan()
}

fn within(zoom: f64) -> (f64, bool) {
    // Rounding alone leaves no range.
    let slack = 1e-9;
    let inside = zoom >= MIN_ZOOM * (1.0 - slack) && zoom <= MAX_ZOOM * (1.0 + slack);
    // NaN, of an angle that is none, counts as the widest.
    let zoom = if zoom.is_nan() { MIN_ZOOM } else { zoom };
    (zoom.clamp(MIN_ZOOM, MAX_ZOOM), inside)
}

/// The quaternion of a camera with these axes: what takes them to the world's.
#[must_use]
pub fn rotation(pose: &Pose, axes: CameraAxes) -> DQuat {
    (pose.rotation() * to_ours(axes)).normalize()
}

/// The matrix of a camera with these axes to the world's coordinates.
#[must_use]
pub fn matrix(pose: &Pose, axes: CameraAxes) -> DMat4 {
    DMat4::from_rotation_translation(rotation(pose, axes), pose.position())
}

/// A rotation and what is added after it, the other way: camera to world to world to camera, and
/// back.
#[must_use]
pub fn inverse(rotation: DQuat, translation: DVec3) -> (DQuat, DVec3) {
    let back = rotation.conjugate();
    (back, -(back * translation))
}

/// A rotation, then a roll about the view by degrees: the camera's own.
#[must_use]
pub fn rolled(rotation: DQuat, degrees: f64) -> DQuat {
    rotation * DQuat::from_rotation_z(degrees.to_radians())
}

/// Rotations one after the other, neighbours in one hemisphere.
#[derive(Debug, Clone, Copy, Default)]
pub struct Continued(Option<DQuat>);

impl Continued {
    /// The rotation, or its negative, which is the same one, if that is nearer to the one before.
    pub fn next(&mut self, rotation: DQuat) -> DQuat {
        let before = self.0;
        let next = before.map_or(rotation, |before| continue_sign(before, rotation).0);
        self.0 = Some(next);
        next
    }
}

/// instant-ngp puts the world of a `transforms.json` into a cube by this scale and then this offset,
/// unless the file names others.
const NGP_SCALE: f64 = 0.33;
const NGP_OFFSET: f64 = 0.5;

/// The x, y and z axes of instant-ngp are the y, z and x axes of `transforms.json`.
const NGP_TURN: DQuat = DQuat::from_xyzw(-0.5, -0.5, -0.5, 0.5);

/// A rotation and a place in the world of `transforms.json` as in the cube of instant-ngp.
#[must_use]
pub fn to_ngp(rotation: DQuat, place: DVec3) -> (DQuat, DVec3) {
    let place = DVec3::new(place.y, place.z, place.x) * NGP_SCALE + NGP_OFFSET;
    (NGP_TURN * rotation, place)
}

/// The inverse of [`to_ngp`].
#[must_use]
pub fn of_ngp(rotation: DQuat, place: DVec3) -> (DQuat, DVec3) {
    let place = (place - NGP_OFFSET) / NGP_SCALE;
    (
        NGP_TURN.conjugate() * rotation,
        DVec3::new(place.z, place.x, place.y),
    )
}

/// SuperSplat turns a PLY by half a turn about z: a vector of either world in the other.
#[must_use]
pub fn supersplat(v: DVec3) -> DVec3 {
    DVec3::new(-v.x, -v.y, v.z)
}

/// Takes the axes of a camera to ours.
fn to_ours(axes: CameraAxes) -> DQuat {
    match axes {
        CameraAxes::Vides => DQuat::IDENTITY,
        CameraAxes::OpenGl => HALF_TURN,
        // By half a turn about the view: (0, 0, 0, 1).
        CameraAxes::OpenCv => DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0),
        // Its x is our z, its y our x, its z our y.
        CameraAxes::Ros => DQuat::from_mat3(&DMat3::from_cols(DVec3::Z, DVec3::X, DVec3::Y)),
    }
}

/// The pose of a camera with these axes at a place, turned by `rotation` from them to the world's.
///
/// # Errors
/// [`Cause::NotFinite`], [`Cause::NoRotation`]; the caller knows the place.
pub fn pose(position: DVec3, rotation: DQuat, axes: CameraAxes, zoom: f64) -> Result<Pose, Cause> {
    if !position.is_finite() || !rotation.is_finite() {
        return Err(Cause::NotFinite);
    }
    let length = rotation.length();
    if !(length > 1e-12 && length.is_finite()) {
        return Err(Cause::NoRotation);
    }
    let ours = (rotation / length) * to_ours(axes).inverse();
    Ok(Pose::new(position, ours.normalize(), zoom))
}

/// The rotation in a matrix: nearly perpendicular columns of one length, made exact.
///
/// # Errors
/// [`Wanted::Rotation`] if it mirrors or shears.
pub fn rotation_of(matrix: DMat3) -> Result<DQuat, Cause> {
    let wrong = || Cause::Expected(Wanted::Rotation);
    if !matrix.is_finite() {
        return Err(Cause::NotFinite);
    }
    let length = matrix.determinant().abs().cbrt();
    if !(length > 1e-12) {
        return Err(wrong());
    }
    let unit = matrix * length.recip();
    let square = unit.transpose() * unit;
    if unit.determinant() < 0.0 || !square.abs_diff_eq(DMat3::IDENTITY, NEARLY) {
        return Err(wrong());
    }
    // View and up, made perpendicular; the third axis follows.
    let view = unit.z_axis.normalize();
    let up = (unit.y_axis - view * unit.y_axis.dot(view)).normalize();
    Ok(quaternion_from_view(view, up))
}

/// An affine map as a scale along the axes, then a turn, then a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parts {
    /// Where the origin goes.
    pub position: DVec3,
    /// Of length 1.
    pub rotation: DQuat,
    /// Along its own axes; a mirrored map is mirrored along x.
    pub scale: DVec3,
    /// Whether there was shear, which is left out.
    pub sheared: bool,
}

/// Takes an affine map apart; what has no direction looks as the axes do.
#[must_use]
pub fn parts(map: DAffine3) -> Parts {
    let [x, y, z] = map.matrix3.to_cols_array_2d().map(DVec3::from_array);
    let mut scale = DVec3::new(x.length(), y.length(), z.length());
    if map.matrix3.determinant() < 0.0 {
        scale.x = -scale.x;
    }
    let unit = |axis: DVec3, length: f64| (axis / length).try_normalize();
    let axes = (unit(x, scale.x), unit(y, scale.y), unit(z, scale.z));
    // Two axes, made perpendicular, give the third.
    let (rotation, sheared) = match axes {
        (Some(x), Some(y), Some(z)) => {
            let dots = x.dot(y).abs().max(y.dot(z).abs()).max(z.dot(x).abs());
            (quaternion_from_view(z, perpendicular(y, z)), dots > SHEARED)
        }
        (None, Some(y), Some(z)) => (quaternion_from_view(z, perpendicular(y, z)), false),
        (Some(x), None, Some(z)) => {
            let x = perpendicular(x, z);
            (quaternion_from_view(z, z.cross(x)), false)
        }
        (Some(x), Some(y), None) => {
            let y = perpendicular(y, x);
            (quaternion_from_view(x.cross(y), y), false)
        }
        (Some(x), None, None) => (DQuat::from_rotation_arc(DVec3::X, x), false),
        (None, Some(y), None) => (DQuat::from_rotation_arc(DVec3::Y, y), false),
        (None, None, Some(z)) => (DQuat::from_rotation_arc(DVec3::Z, z), false),
        (None, None, None) => (DQuat::IDENTITY, false),
    };
    Parts {
        position: map.translation,
        rotation: rotation.normalize(),
        scale,
        sheared,
    }
}

/// A unit vector perpendicular to `to`, as near `v` as there is one.
fn perpendicular(v: DVec3, to: DVec3) -> DVec3 {
    let off = v - to * v.dot(to);
    off.try_normalize()
        .unwrap_or_else(|| to.any_orthonormal_vector())
}

/// Axes whose cosine is larger than this are sheared: more than numbers of 32 bits round.
const SHEARED: f64 = 1e-5;

/// Turns a world from one up axis to the opposite convention: y to z is (x, −z, y).
#[must_use]
pub fn turn(from: Up, to: Up) -> DQuat {
    // By a quarter about x, exact in both vectors and matrices.
    let quarter = std::f64::consts::FRAC_1_SQRT_2;
    match (from, to) {
        (Up::Y, Up::Z) => DQuat::from_xyzw(quarter, 0.0, 0.0, quarter),
        (Up::Z, Up::Y) => DQuat::from_xyzw(-quarter, 0.0, 0.0, quarter),
        _ => DQuat::IDENTITY,
    }
}

/// A vector in a world turned as by [`turn`], without rounding.
#[must_use]
pub fn turned(v: DVec3, from: Up, to: Up) -> DVec3 {
    match (from, to) {
        (Up::Y, Up::Z) => DVec3::new(v.x, -v.z, v.y),
        (Up::Z, Up::Y) => DVec3::new(v.x, v.z, -v.y),
        _ => v,
    }
}

/// The time of a pose in seconds, by its index from 0: pose n is at (n − 1)/fps.
#[must_use]
pub fn seconds(index: usize, fps: f64) -> f64 {
    index as f64 / fps
}

impl Place {
    /// The pose that [`pose`] makes, its error at this place.
    ///
    /// # Errors
    /// As [`pose`].
    pub fn pose(
        self,
        position: DVec3,
        rotation: DQuat,
        axes: CameraAxes,
        zoom: f64,
    ) -> Result<Pose> {
        pose(position, rotation, axes, zoom).map_err(|cause| self.wrong(cause))
    }

    /// The pose of a camera with these axes whose matrix to world coordinates this is.
    ///
    /// # Errors
    /// [`Wanted::Rotation`], [`Cause::NotFinite`], at this place.
    pub fn matrix(self, matrix: DMat4, axes: CameraAxes, zoom: f64) -> Result<Pose> {
        match rotation_of(DMat3::from_mat4(matrix)) {
            Ok(turn) => self.pose(matrix.w_axis.truncate(), turn, axes, zoom),
            Err(cause) => Err(self.wrong(cause)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [CameraAxes; 4] = [
        CameraAxes::OpenGl,
        CameraAxes::OpenCv,
        CameraAxes::Ros,
        CameraAxes::Vides,
    ];

    /// Held against the matrices of the engine, which C hosts test.
    #[test]
    fn quaternions_are_those_of_the_matrices() {
        let turn = DQuat::from_xyzw(0.3, -0.5, 0.1, 0.7).normalize();
        let ours = Pose::new(DVec3::new(1.0, 2.0, 3.0), turn, 35.0);
        for axes in ALL {
            let matrix = DMat3::from_mat4(ours.to_world(axes).unwrap());
            let by_quaternion = DMat3::from_quat(rotation(&ours, axes));
            assert!(matrix.abs_diff_eq(by_quaternion, 1e-15), "{axes:?}");
            let again = rotation_of(matrix).unwrap();
            let back = pose(ours.position(), again, axes, 35.0).unwrap();
            for (a, b) in [(back.vpn, ours.vpn), (back.vup, ours.vup)] {
                assert!((DVec3::from(a) - DVec3::from(b)).length() < 1e-15);
            }
        }
        let gl = rotation(&ours, CameraAxes::OpenGl);
        assert!((gl - turn * DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0)).length() < 1e-15);
    }

    #[test]
    fn an_inverse_undoes_a_rotation_and_a_translation() {
        let turn = DQuat::from_xyzw(0.3, -0.5, 0.1, 0.7).normalize();
        let place = DVec3::new(1.0, 2.0, 3.0);
        let (back, there) = inverse(turn, turn * place);
        assert!(
            (back * DVec3::ZERO + there + place).length() < 4.0 * f64::EPSILON * place.length()
        );
    }

    #[test]
    fn fields_of_view_beyond_the_range_are_clamped() {
        for zoom in [1.0, 24.0, 2000.0] {
            let (again, inside) = zoom_of_field(field_of_view(zoom));
            assert!((again - zoom).abs() < 1e-9 * zoom && inside);
            assert!(
                (zoom_of_focal(focal_pixels(zoom, 1080.0), 1080.0).0 - zoom).abs() < 1e-9 * zoom
            );
        }
        assert_eq!(zoom_of_field(3.1), (1.0, false));
        assert_eq!(zoom_of_field(1e-6), (2000.0, false));
        assert_eq!(zoom_of_field(f64::NAN), (1.0, false));
        // 90° wide on a square picture are 90° high.
        let (zoom, _) = zoom_of_focal(focal_of_width(std::f64::consts::FRAC_PI_2, 500.0), 500.0);
        assert!((zoom - 12.0).abs() < 1e-12);
    }

    #[test]
    fn worlds_turn_about_x() {
        let v = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(turned(v, Up::Y, Up::Z), DVec3::new(1.0, -3.0, 2.0));
        for (from, to) in [(Up::Y, Up::Z), (Up::Z, Up::Y), (Up::Z, Up::Z)] {
            assert!((turn(from, to) * v - turned(v, from, to)).length() < 1e-15);
            assert_eq!(turned(turned(v, from, to), to, from), v);
        }
    }

    #[test]
    fn maps_come_apart_and_together() {
        let turn = DQuat::from_xyzw(0.3, -0.5, 0.1, 0.7).normalize();
        let place = DVec3::new(1.0, 2.0, 3.0);
        for scale in [
            DVec3::ONE,
            DVec3::new(-2.0, 3.0, 0.5),
            DVec3::new(2.0, 0.0, 3.0),
            DVec3::new(0.0, 2.0, 3.0),
            DVec3::new(2.0, 3.0, 0.0),
            DVec3::new(0.0, 0.0, 3.0),
            DVec3::new(0.0, 2.0, 0.0),
            DVec3::ZERO,
        ] {
            let map = DAffine3::from_scale_rotation_translation(scale, turn, place);
            let found = parts(map);
            let again = DAffine3::from_scale_rotation_translation(
                found.scale,
                found.rotation,
                found.position,
            );
            assert!(again.abs_diff_eq(map, 1e-14), "{scale}");
            assert!(!found.sheared);
        }
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(0.5, 1.0, 0.0), DVec3::Z);
        assert!(parts(DAffine3::from_mat3(shear)).sheared);
        assert!(!parts(DAffine3::from_mat3(DMat3::ZERO)).sheared);
    }

    #[test]
    fn what_is_no_rotation_is_refused() {
        let mirror = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let shear = DMat3::from_cols(DVec3::X, DVec3::new(0.5, 1.0, 0.0), DVec3::Z);
        for matrix in [DMat3::ZERO, mirror, shear, DMat3::NAN] {
            assert!(rotation_of(matrix).is_err());
        }
        let scaled = DMat3::from_quat(DQuat::from_rotation_y(1.0)) * 3.0;
        assert!(
            rotation_of(scaled)
                .unwrap()
                .dot(DQuat::from_rotation_y(1.0))
                .abs()
                > 1.0 - 1e-15
        );
    }
}
