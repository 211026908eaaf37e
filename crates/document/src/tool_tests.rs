use vides_engine::scene::Mesh;

use super::*;

use crate::{At, Edit, Object, StepName};

/// A path with four points about (0.2, 0, 0).
fn document() -> Document {
    let mut document = Document::new();
    for (at, place) in [(0.0, 0.1), (0.4, 0.3), (0.4, -0.2), (0.0, -0.2)]
        .into_iter()
        .enumerate()
    {
        let position = DVec3::new(place.0, place.1, 0.5 - 0.3 * at as f64);
        let edit = if at < 2 {
            Edit::set(At::Point(at), "position", position)
        } else {
            Edit::InsertPoint { at, position }
        };
        document.apply(edit).unwrap();
    }
    document.select(1, 0).unwrap();
    document
}

fn tetrahedron() -> Object {
    Object::of_mesh(Mesh {
        points: vec![DVec3::ZERO, 0.2 * DVec3::X, 0.2 * DVec3::Y, 0.2 * DVec3::Z],
        triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        ..Mesh::default()
    })
    .unwrap()
}

fn tool(name: &str) -> Tool {
    tools().find(|tool| tool.name == name).unwrap()
}

/// Its edit with some numbers set by name.
fn edit(document: &Document, name: &str, set: &[(&str, f64)]) -> Result<Option<Edit>> {
    let tool = tool(name);
    let mut numbers = tool.defaults(document).unwrap();
    for (name, value) in set {
        if let Some(at) = tool.place_of(name) {
            numbers[at] = *value;
        }
    }
    let material = match tool.needs() {
        Needs::Block => ToolInput::Block(Box::default()),
        Needs::Poses => {
            let sampler = document.sampler().unwrap();
            let mut poses = vec![Pose::default(); sampler.frame_count()];
            sampler.sample(1, &mut poses).unwrap();
            ToolInput::Poses(poses, None, document.path().space.up)
        }
        Needs::Stroke => {
            let places = (0..50).map(|step| 0.02 * f64::from(step));
            ToolInput::Stroke(places.map(|x| DVec3::new(x, x * x, 0.1)).collect())
        }
        // The way is led clear of the document's own object.
        Needs::Nothing if tool.asks_object() && tool.name != "avoid" => {
            let corners = [[-0.3, 0.0, -3.0], [0.3, 0.1, -3.0], [0.0, 0.4, -3.2]];
            let mesh = Mesh {
                points: corners.map(DVec3::from_array).to_vec(),
                ..Mesh::default()
            };
            ToolInput::Object(Arc::new(Clearance::new(&mesh).unwrap()))
        }
        Needs::Nothing | Needs::Output => ToolInput::None,
    };
    let made = tool.edit(document, &material, &numbers, &mut |_, _| true)?;
    Ok(made.edit)
}

#[test]
fn each_tool_changes_a_path_in_one_step_that_leaves_nothing_behind() {
    let mut names = Vec::new();
    for tool in tools() {
        assert!(!names.contains(&tool.name), "{}", tool.name);
        names.push(tool.name);
        let mut document = document();
        if tool.name == "avoid" {
            // A line across the way.
            let middle = document.sampler().unwrap().pose(20.0).unwrap().position();
            let mesh = crate::Object::of_mesh(vides_engine::scene::Mesh {
                points: vec![middle - DVec3::Z, middle + DVec3::Z],
                lines: vec![[0, 1]],
                ..Default::default()
            });
            let mut info = document.info().clone();
            info.object = mesh.unwrap();
            document = Document::from_parts(document.path().clone(), info).unwrap();
        }
        if tool.name == "tour" {
            let mut info = document.info().clone();
            info.object = tetrahedron();
            document.apply(Edit::SetInfo(Box::new(info))).unwrap();
        }
        let before = document.path().clone();
        let set = [("by", 0.1), ("frames", 100.0), ("lattice", -0.7)];
        let Some(edit) = edit(&document, tool.name, &set).unwrap() else {
            assert_eq!(tool.needs(), Needs::Output);
            continue;
        };
        document.begin_step();
        document.apply(edit).unwrap();
        document.name_step(StepName::Tool(tool.name));
        document.end_step();
        assert_ne!(*document.path(), before, "{}", tool.name);
        assert_eq!(
            document.step_names(),
            [Some(StepName::Tool(tool.name)), None]
        );
        assert!(document.undo());
        assert_eq!(*document.path(), before, "{}", tool.name);
        assert_eq!(document.step_names()[1], Some(StepName::Tool(tool.name)));
    }
}

/// A quarter turn about z is (x, y) to (−y, x).
#[test]
fn points_are_turned_about_what_is_chosen() {
    let quarter = [("axis", 2.0), ("first", 2.0), ("last", 3.0)];
    for (about, centre) in [(0.0, [0.4, 0.05]), (1.0, [0.0, 0.0]), (2.0, [0.4, 0.3])] {
        let mut document = document();
        let before = document.path().clone();
        let mut set = quarter.to_vec();
        set.push(("about", about));
        let edit = edit(&document, "turn", &set).unwrap().unwrap();
        document.apply(edit).unwrap();
        for (at, old) in before.points.iter().enumerate() {
            let [x, y] = [old.position.x - centre[0], old.position.y - centre[1]];
            let turned = DVec3::new(centre[0] - y, centre[1] + x, old.position.z);
            let picked = (1..3).contains(&at);
            let wanted = if picked { turned } else { old.position };
            let found = document.path().points[at].position;
            assert!((found - wanted).length() < 1e-15, "{about} {at}: {found}");
        }
    }
}

#[test]
fn points_are_mirrored_and_scaled_about_the_target() {
    let mut document = document();
    let target = DVec3::new(0.1, -0.4, 0.2);
    let mut orientation = document.path().points[1].orientations[0].clone();
    orientation.target = Target::Absolute(target);
    let look = Edit::SetOrientation {
        point: 1,
        at: 0,
        orientation,
    };
    document.apply(look).unwrap();
    let before = document.path().clone();
    for (name, set, factor) in [
        ("mirror", ("axis", 0.0), DVec3::new(-1.0, 1.0, 1.0)),
        ("scale", ("factor", 0.25), DVec3::splat(0.25)),
    ] {
        let edit = edit(&document, name, &[set, ("about", 3.0)])
            .unwrap()
            .unwrap();
        document.apply(edit).unwrap();
        for (new, old) in document.path().points.iter().zip(&before.points) {
            let wanted = target + factor * (old.position - target);
            assert!((new.position - wanted).length() < 1e-15, "{name}");
        }
        document.undo();
    }
}

#[test]
fn a_move_lies_around_the_object_and_goes_on_behind_the_current_point() {
    let document = document();
    let numbers = tool("orbit").defaults(&document).unwrap();
    let Some(Edit::ReplacePath(orbit)) = tool("orbit")
        .edit(&document, &ToolInput::None, &numbers, &mut |_, _| true)
        .unwrap()
        .edit
    else {
        panic!("no new path");
    };
    assert_eq!(orbit.space, document.path().space);
    for point in &orbit.points {
        let [x, _, z] = point.position.to_array();
        assert!((x.hypot(z) - 1.0).abs() < 1e-12);
    }
    let last = document.path().points.len() - 1;
    for (put, expected) in [(1.0, 1), (2.0, last)] {
        for (place, wanted) in [
            (0.0, Fit::None),
            (1.0, Fit::Move),
            (2.0, Fit::Turn),
            (3.0, Fit::Scale),
        ] {
            let numbers = [("put", put), ("fit", place)];
            let Some(Edit::InsertPath { at, fit, .. }) =
                edit(&document, "orbit", &numbers).unwrap()
            else {
                panic!("no block");
            };
            assert_eq!((at, fit), (expected, wanted));
        }
    }
}

#[test]
fn what_will_not_do_is_refused_by_its_name() {
    let document = document();
    for (name, set, said) in [
        (
            "orbit",
            ("radius", -1.0),
            "radius must lie between 0.000001 and 1e9",
        ),
        ("turn", ("last", 5.0), "last must lie between 1 and 4"),
        ("turn", ("angle", f64::NAN), "angle must be a finite number"),
        (
            "move",
            ("first", 5.0),
            "the first point of a range, 5, must not lie behind its last one, 4",
        ),
    ] {
        let error = edit(&document, name, &[set]).unwrap_err();
        assert_eq!(error.to_string(), said);
    }
    assert!(edit(&document, "extract", &[("first", 4.0)]).is_err());
}

#[test]
fn a_block_is_a_document_of_its_own() {
    let document = document();
    let mut numbers = tool("extract").defaults(&document).unwrap();
    numbers[0] = 2.0;
    let block = tool("extract").extracted(&document, &numbers).unwrap();
    let places = |document: &Document| -> Vec<DVec3> {
        let points = &document.path().points;
        points.iter().map(|point| point.position).collect()
    };
    assert_eq!(places(&block), places(&document)[1..]);
}

/// Points in a plane can be moved out of it by a free form; untouched it moves none.
#[test]
fn a_free_form_bends_what_is_flat() {
    let mut document = Document::new();
    for at in 0..2 {
        let position = DVec3::new(at as f64 - 0.5, 0.2, 0.3 * at as f64);
        document
            .apply(Edit::set(At::Point(at), "position", position))
            .unwrap();
    }
    let place = |document: &Document| document.path().points[0].position;
    let (before, tool) = (place(&document), tool("free-form"));
    let mut numbers = tool.defaults(&document).unwrap();
    for (lowered, moved) in [(0.0, 0.0), (1.0, 0.25)] {
        for node in 0..64 {
            numbers[3 * node + 1] -= lowered;
        }
        let made = tool
            .edit(&document, &ToolInput::None, &numbers, &mut |_, _| true)
            .unwrap();
        document.begin_step();
        document.apply(made.edit.unwrap()).unwrap();
        let way = before - place(&document);
        assert!(way.distance(DVec3::new(0.0, moved, 0.0)) < 1e-12, "{way}");
        document.cancel_step();
    }
}
