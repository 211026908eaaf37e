//! What files of others hold.

use glam::{DAffine3, DMat4, DQuat, DVec3};
use vides_engine::scene::{Channel, Interpolation, Kind};

use super::tests::{matrix, not_taken, prim, read, states};
use crate::{Imported, Loss};

/// Each operation by its definition: column vectors, the first operation outermost.
#[test]
fn operations_by_their_definition() {
    let [x, y, z] = [30.0_f64, 40.0, 50.0].map(f64::to_radians);
    let turn = |axis, angle| DAffine3::from_quat(DQuat::from_axis_angle(axis, angle));
    let (rx, ry, rz) = (turn(DVec3::X, x), turn(DVec3::Y, y), turn(DVec3::Z, z));
    let t = DAffine3::from_translation(DVec3::new(1.0, 2.0, 3.0));
    let s = DAffine3::from_scale(DVec3::new(-2.0, 3.0, 0.5));
    let angles = "(30, 40, 50)";
    let cases = [
        (
            "double3 xformOp:translate = (1, 2, 3)",
            r#""xformOp:translate""#,
            t,
        ),
        (
            "float3 xformOp:rotateXYZ = ANGLES",
            r#""xformOp:rotateXYZ""#,
            rz * ry * rx,
        ),
        (
            "float3 xformOp:rotateXZY = ANGLES",
            r#""xformOp:rotateXZY""#,
            ry * rz * rx,
        ),
        (
            "float3 xformOp:rotateYXZ = ANGLES",
            r#""xformOp:rotateYXZ""#,
            rz * rx * ry,
        ),
        (
            "float3 xformOp:rotateYZX = ANGLES",
            r#""xformOp:rotateYZX""#,
            rx * rz * ry,
        ),
        (
            "float3 xformOp:rotateZXY = ANGLES",
            r#""xformOp:rotateZXY""#,
            ry * rx * rz,
        ),
        (
            "half3 xformOp:rotateZYX = ANGLES",
            r#""xformOp:rotateZYX""#,
            rx * ry * rz,
        ),
        ("float xformOp:rotateX = 30", r#""xformOp:rotateX""#, rx),
        ("float xformOp:rotateY:a = 40", r#""xformOp:rotateY:a""#, ry),
        (
            "float xformOp:rotateZ = 50",
            r#""!invert!xformOp:rotateZ""#,
            rz.inverse(),
        ),
        (
            "quatf xformOp:orient = (2, 2, 0, 0)",
            r#""xformOp:orient""#,
            turn(DVec3::X, 0.5 * std::f64::consts::PI),
        ),
        (
            "double xformOp:translateY = 2\nfloat xformOp:scaleZ = 3",
            r#""xformOp:translateY", "xformOp:scaleZ""#,
            DAffine3::from_translation(DVec3::Y * 2.0)
                * DAffine3::from_scale(DVec3::new(1.0, 1.0, 3.0)),
        ),
        (
            "double3 xformOp:translate = (1, 2, 3)\nfloat3 xformOp:scale = (-2, 3, 0.5)\nfloat3 xformOp:rotateXYZ = ANGLES",
            r#""xformOp:translate", "xformOp:rotateXYZ", "xformOp:scale""#,
            t * rz * ry * rx * s,
        ),
        (
            "double3 xformOp:translate:pivot = (1, 2, 3)\nfloat xformOp:rotateX = 30",
            r#""xformOp:translate:pivot", "xformOp:rotateX", "!invert!xformOp:translate:pivot""#,
            t * rx * t.inverse(),
        ),
        (
            "matrix4d xformOp:transform = ((0, 2, 0, 0), (-3, 0, 0, 0), (0, 0, 4, 0), (5, 6, 7, 1))",
            r#""xformOp:transform""#,
            DAffine3::from_mat4(DMat4::from_cols_array(&[
                0., 2., 0., 0., -3., 0., 0., 0., 0., 0., 4., 0., 5., 6., 7., 1.,
            ])),
        ),
        // Half of it moves: keys are computed.
        (
            "float xformOp:rotateX.timeSamples = { 1: 30, 2: 30 }\ndouble3 xformOp:translate = (1, 2, 3)",
            r#""xformOp:rotateX", "xformOp:translate""#,
            rx * t,
        ),
    ];
    for (lines, order, wanted) in cases {
        let lines = format!(
            "{}\nuniform token[] xformOpOrder = [{order}]",
            lines.replace("ANGLES", angles)
        );
        let is = read(&prim("Xform", &lines)).document;
        let is = matrix(&is, "it", 1.0);
        assert!(is.abs_diff_eq(wanted, 1e-12), "{lines}\n{is}\n{wanted}");
    }
}

#[test]
fn cameras_look_along_minus_z() {
    let is = read(&prim(
        "Camera",
        "quatf xformOp:orient = (1, 0, 1, 0)\nuniform token[] xformOpOrder = [\"xformOp:orient\"]",
    ));
    let (_, state) = &states(&is.document, 1.0)[0];
    assert!(DVec3::from(state.pose.vpn).abs_diff_eq(DVec3::NEG_X, 1e-15));
    assert!(DVec3::from(state.pose.vup).abs_diff_eq(DVec3::Y, 1e-15));
}

#[test]
fn turns_of_more_than_one_round_are_kept() {
    let lines = "float xformOp:rotateY.timeSamples = { 1: 0, 11: 1440 }\nuniform token[] xformOpOrder = [\"xformOp:rotateY\"]";
    for (kind, by) in [
        ("Xform", Interpolation::EulerLinear),
        ("Camera", Interpolation::Linear),
    ] {
        let Imported {
            document, report, ..
        } = read(&prim(kind, lines));
        let track = document.scene.nodes()[0]
            .keys()
            .track(&Channel::Rotation)
            .unwrap();
        assert_eq!(*track.interpolation(), by);
        assert_eq!(
            report.losses().contains(&Loss::Resampled(1)),
            by == Interpolation::Linear
        );
        for (frame, degrees) in [(2.0, 144.0_f64), (5.0, 576.0)] {
            let turn = DQuat::from_rotation_y(degrees.to_radians());
            let wanted = if kind == "Camera" {
                turn * crate::convention::HALF_TURN
            } else {
                turn
            };
            assert!(matrix(&document, "it", frame).abs_diff_eq(DAffine3::from_quat(wanted), 1e-12));
        }
    }
}

/// A file with something of everything.
pub(super) const ALL: &str = r#"#usda 1.0
(
    "a comment"
    defaultPrim = "World"
    doc = """Two
lines"""
    metersPerUnit = 0.01
    upAxis = "Z"
    startTimeCode = 10
    endTimeCode = 20
    timeCodesPerSecond = 30
    subLayers = [@other.usda@ (offset = 1)]
)

class "_base" { float a = 1 }
def Xform "World" (
    kind = "component"
    prepend references = [@a.usda@</A> (scale = 2), </B>]
    variants = { string look = "red" }
    prepend variantSets = "look"
)
{
    variantSet "look" = {
        "red" ( payload = None ) { def Mesh "no" {} }
    }
    reorder nameChildren = ["camera", "sun"]
    rel material:binding = </World/Looks>
    double3 xformOp:translate = (0, 0, 100)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def Camera "camera" ( displayName = "Kamera \"1\"" )
    {
        float focalLength.timeSamples = { 10: 50, 20: 100, }
        float verticalAperture = 24
        float horizontalApertureOffset = 1
        float2 clippingRange = (1, 500)
        token visibility.timeSamples = { 10: "inherited", 12: "invisible", }
        custom string note = "x"; int after = 1
        double3 xformOp:translate.timeSamples = { 10: (0, 0, 0), 15: None, 20: (0, 10, 0) }
        uniform token[] xformOpOrder = ["!resetXformStack!", "xformOp:translate"]
    }
    def SphereLight "lamp" ( prepend apiSchemas = ["ShapingAPI"] )
    {
        color3f inputs:color = (1, 0.5, 0)
        float inputs:intensity = 3
        float inputs:exposure = 2
        float inputs:shaping:cone:angle = 40
        float inputs:shaping:cone:softness = 0.25
    }
    def DistantLight "sun" ( instanceable = true ) {}
    def Mesh "mesh"
    {
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 2, 2)]
        int[] faceVertexCounts = [4, 3]
        int[] faceVertexIndices = [0, 1, 2, 3, 2, 3, 4]
        color3f[] primvars:displayColor = [(0, 0, 0), (1, 1, 1), (0.2, 0, 0), (0, 0, 0), (0, 0, 0)] (
            interpolation = "vertex"
        )
        rel skel:skeleton = </World/Skeleton>
    }
    def BasisCurves "curves"
    {
        uniform token type = "linear"
        uniform token wrap = "periodic"
        int[] curveVertexCounts = [3, 2]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 2, 2)]
        color3f[] primvars:displayColor = [(0.5, 0.25, 1)]
    }
    def Points "points" { point3f[] points = [(0, 0, 0), (1, 0, 0)] }
    def Scope "Looks" { def Material "red" { def Shader "s" { asset inputs:file = @a.png@ } } }
    def Cube "cube" ( active = false ) {}
    over "other" {}
}
"#;

#[test]
fn everything_is_taken_or_told() {
    let Imported {
        document, report, ..
    } = read(ALL);
    let info = &document.info;
    assert_eq!((info.fps, info.first_frame), (30.0, 10));
    assert_eq!(
        (info.unit.as_str(), info.comment.as_str()),
        ("cm", "Two\nlines")
    );
    assert_eq!(document.scene.space().up, vides_engine::path::Up::Z);
    let names: Vec<_> = document
        .scene
        .nodes()
        .iter()
        .map(|node| node.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "World",
            "Kamera \"1\"",
            "lamp",
            "sun",
            "mesh",
            "curves",
            "points"
        ]
    );
    // The camera lies in the world, not in what is raised by 100.
    let camera = &document.scene.nodes()[1];
    assert_eq!(camera.parent, None);
    assert_eq!(
        matrix(&document, "Kamera \"1\"", 6.0).translation,
        DVec3::ZERO,
    );
    let Kind::Camera(planes) = camera.kind else {
        panic!()
    };
    assert_eq!((planes.near, planes.far), (1.0, 500.0));
    let at = |frame| states(&document, frame)[1].1;
    assert!((at(6.0).pose.zoom - 75.0).abs() < 1e-12);
    assert_eq!((at(2.9).visible, at(3.0).visible), (1, 0));
    let lamp = states(&document, 1.0)[2].1;
    // Luminance times the area seen of a sphere of 5 mm: 12 π 0.005².
    assert!((lamp.intensity - 9.424_777_960_769_38e-4).abs() < 1e-15);
    assert_eq!(lamp.cone, [30.0, 40.0]);
    assert_eq!(matrix(&document, "mesh", 1.0).translation, DVec3::Z * 100.0);
    let object = |at: usize| match &document.scene.nodes()[at].kind {
        Kind::Object(object) => object,
        _ => panic!(),
    };
    assert_eq!(
        object(4).mesh().triangles,
        [[0, 1, 2], [0, 2, 3], [2, 3, 4]]
    );
    // 0.2 linear is 124 of sRGB (IEC 61966-2-1).
    assert_eq!(object(4).mesh().colours[1..3], [[255; 3], [124, 0, 0]]);
    assert_eq!(object(5).mesh().lines, [[0, 1], [1, 2], [2, 0], [3, 4]]);
    assert_eq!(document.scene.nodes()[5].rest.colour, [0.5, 0.25, 1.0]);
    assert_eq!(object(6).mesh().points.len(), 2);
    let mut told = not_taken(&report);
    told.sort();
    let wanted = [
        "!resetXformStack!",
        "Material",
        "Shader",
        "class",
        "instanceable",
        "over",
        "references",
        "subLayers",
        "subdivisionScheme",
        "variantSets",
    ];
    assert_eq!(told, wanted.map(|what| (what.to_owned(), 1)));
    for loss in [Loss::OffCentre(1), Loss::Skins(1)] {
        assert!(report.losses().contains(&loss), "{loss}");
    }
}

#[test]
fn what_an_xform_is_for_becomes_one_node() {
    let turned = "float xformOp:rotateY = 90\nuniform token[] xformOpOrder = [\"xformOp:rotateY\"]";
    let text = prim(
        "Xform",
        &format!("{turned}\ndef Camera \"it\" {{ float focalLength = 20 }}"),
    );
    let document = read(&text).document;
    let nodes = document.scene.nodes();
    assert_eq!((nodes.len(), nodes[0].kind.name()), (2, "camera"));
    let state = states(&document, 1.0)[0].1;
    assert!(DVec3::from(state.pose.vpn).abs_diff_eq(DVec3::NEG_X, 1e-15));
    // With another child each stays what it is.
    let text = text.replace("{ float", "{ } def Camera \"b\" { float");
    assert_eq!(read(&text).document.scene.nodes().len(), 4);
}

/// A number behind the longest name must not make it longer.
#[test]
fn the_longest_names_are_numbered_too() {
    let name = "n".repeat(vides_engine::limits::MAX_NAME_BYTES);
    let prim = format!("def Camera \"{name}\" {{}}\n");
    let read = read(&format!(
        "#usda 1.0\ndef \"a\"\n{{\n{prim}}}\ndef \"b\"\n{{\n{prim}}}\n"
    ));
    let nodes = read.document.scene.nodes();
    let cameras = nodes
        .iter()
        .filter(|node| matches!(node.kind, Kind::Camera(_)));
    assert_eq!(cameras.count(), 2);
}

/// Nothing times the brightest exposure is nothing.
#[test]
fn exposures_without_end_leave_the_dark_dark() {
    for (intensity, bright) in [(0.0, 0.0), (1.0, vides_engine::limits::MAX_COORDINATE)] {
        let light = format!("float inputs:intensity = {intensity}\nfloat inputs:exposure = 1e30");
        let read = read(&prim("SphereLight", &light));
        let it = read.document.scene.find("it").unwrap();
        assert_eq!(
            read.document.scene.nodes()[it].rest.intensity.to_bits(),
            f64::to_bits(bright)
        );
    }
}
