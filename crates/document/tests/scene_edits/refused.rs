//! What must not be is refused with a sentence, and nothing changes.

use vides_document::Edit;
use vides_engine::scene::{
    Channel, Extrapolation, Interpolation, Keep, Kind, Manner, Node, Part, Rest,
};

use crate::maker::whole;
use crate::{furnished, keys, linear, part, shape};

type Wrong = Vec<(Edit, &'static str)>;

fn nodes() -> Wrong {
    let rest = |at: usize, change: &dyn Fn(&mut Rest)| {
        let mut rest = Rest::of(&furnished().scene().unwrap().nodes()[at]);
        change(&mut rest);
        part(Part::Rest {
            node: at,
            rest: Box::new(rest),
        })
    };
    let parent = |node, parent, keep| Edit::SetParent { node, parent, keep };
    let name = |node, name: &str| {
        let name = name.to_owned();
        part(Part::Name { node, name })
    };
    vec![
        (
            parent(2, Some(3), Keep::Numbers),
            "node \"box\" cannot be in \"turned\", which is in it or moves with it",
        ),
        (
            parent(2, Some(2), Keep::Place),
            "node \"box\": it cannot be in itself",
        ),
        (parent(3, None, Keep::Place), "shear"),
        (parent(1, Some(2), Keep::Place), "\"lamp\" moves"),
        (name(1, "box"), "there is a node \"box\" already"),
        (name(1, ""), "name"),
        (
            Edit::AddNodes(vec![Node::new("lamp", Kind::Group)]),
            "there is a node \"lamp\" already",
        ),
        (
            Edit::AddNodes(vec![
                Node::new("x", Kind::Group),
                Node::new("x", Kind::Group),
            ]),
            "there is a node \"x\" already",
        ),
        (
            rest(1, &|rest| rest.values.intensity = -1.0),
            "node \"lamp\": ",
        ),
        (
            rest(1, &|rest| rest.values.position.x = f64::NAN),
            "node \"lamp\": the position",
        ),
        (rest(0, &|rest| rest.kind = Kind::Group), "camera"),
    ]
}

fn keys_and_tracks() -> Wrong {
    let (position, intensity) = (Channel::Position, Channel::Intensity);
    vec![
        (
            keys(position.clone(), &[], &[2.0], &[1.0]),
            "node \"lamp\": channel \"position\": 1 keys",
        ),
        (
            keys(position.clone(), &[], &[2.0], &[1.0, f64::NAN, 0.0]),
            "node \"lamp\": channel \"position\": key 2: a value must be",
        ),
        (
            keys(intensity.clone(), &[1], &[f64::INFINITY], &[1.0]),
            "node \"lamp\": channel \"intensity\": key 3: a frame must be",
        ),
        (
            keys(intensity.clone(), &[0], &[2.0], &[-1.0]),
            "node \"lamp\": channel \"intensity\": key 1: a value lies outside",
        ),
        (
            keys(intensity.clone(), &[], &[7.0, 6.0], &[1.0, 1.0]),
            "node \"lamp\": channel \"intensity\": key 4: its frame must lie behind",
        ),
        (
            keys(intensity.clone(), &[7], &[], &[]),
            "channel \"intensity\": there is no key 8 among 3, counted from 1",
        ),
        (
            keys(Channel::Zoom, &[], &[2.0], &[1.0]),
            "\"lamp\" has no keys of \"zoom\"",
        ),
        (
            part(
                Part::track(
                    1,
                    Channel::Zoom,
                    Some(linear(Channel::Zoom, &[1.0], &[2.0])),
                )
                .unwrap(),
            ),
            "a light has no channel \"zoom\"",
        ),
        (
            part(
                Part::track(
                    0,
                    position.clone(),
                    Some(linear(position.clone(), &[1.0], &[0.0; 3])),
                )
                .unwrap(),
            ),
            "\"camera\" follows a path, which moves its position",
        ),
        (
            part(Part::Manner {
                node: 1,
                channel: intensity.clone(),
                manner: Box::new(Manner {
                    interpolation: Interpolation::Hermite,
                    shape: vec![0.0],
                    before: Extrapolation::Hold,
                    after: Extrapolation::Hold,
                }),
            }),
            "node \"lamp\": channel \"intensity\": ",
        ),
        (
            part(Part::Track {
                node: 1,
                channel: position.clone(),
                track: Some(std::sync::Arc::new(linear(
                    intensity.clone(),
                    &[1.0],
                    &[2.0],
                ))),
            }),
            "keys of \"intensity\" do not fit the channel \"position\"",
        ),
    ]
}

fn objects_and_markers() -> Wrong {
    vec![
        (
            part(Part::insert_shape(2, 0, shape("c", 3)).unwrap()),
            "node \"box\": ",
        ),
        (
            part(Part::Weights {
                node: 2,
                weights: vec![1.0],
            }),
            "node \"box\": 2 shapes need",
        ),
        (
            part(Part::RemoveShape { node: 2, at: 2 }),
            "there is no shape 2 among 2",
        ),
        (
            part(Part::RemoveDeformation { node: 2, at: 0 }),
            "there is no deformation 0 among 0",
        ),
        (
            part(Part::Pin {
                node: 0,
                point: 9,
                marker: None,
            }),
            "\"camera\"",
        ),
        (
            part(Part::Pin {
                node: 0,
                point: 0,
                marker: Some("m".into()),
            }),
            "there is no marker \"m\"",
        ),
        (
            part(Part::Marker {
                name: "m".into(),
                frame: Some(f64::NAN),
            }),
            "frame",
        ),
        (
            Edit::RenameMarker {
                from: "m".into(),
                to: "n".into(),
            },
            "there is no marker \"m\"",
        ),
        (
            part(Part::Range(Some((5.0, 1.0)))),
            "the last frame must not lie before",
        ),
        (part(Part::Camera(Some(1))), "\"lamp\""),
        (part(Part::Camera(Some(9))), "9"),
        (part(Part::Remove(vec![9])), "9"),
        (Edit::CopyNodes(vec![9]), "9"),
    ]
}

#[test]
fn what_must_not_be_is_refused_with_a_sentence_and_nothing_changes() {
    let mut document = furnished();
    let before = whole(&document);
    let wrong = [nodes(), keys_and_tracks(), objects_and_markers()];
    let mut others = Vec::new();
    for (edit, sentence) in wrong.into_iter().flatten() {
        let error = document.apply(edit.clone()).unwrap_err().to_string();
        if !error.contains(sentence) {
            others.push(format!("{error}, not {sentence}"));
        }
        assert_eq!(whole(&document), before, "{edit:?}");
    }
    assert!(others.is_empty(), "{others:#?}");
}
