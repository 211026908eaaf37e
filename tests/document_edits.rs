//! Every edit, in any order, with good and bad values: the document stays one
//! that can be saved, and undo and redo restore every bit.

#[path = "document_edits/raw.rs"]
mod raw;

use glam::DVec3;
use proptest::prelude::*;
use vides::document::{Document, Edit, Info, ObjectPoint, Selection};
use vides::error::ErrorKind;
use vides::path::{CameraPath, Space};
use vides::scene::{self, Extrapolation, FollowPath, Node, Scene};

use raw::{KINDS, Raw, SELECT, kind, raw};

/// Everything that undo restores; `{:?}` tells 0 from −0 and gives every digit.
fn whole(document: &Document) -> String {
    format!("{} {:?}", content(document, true), document.selection())
}

/// With the edited path as it was when its node was chosen, which the scene holds, if that is `held`.
fn content(document: &Document, held: bool) -> String {
    let scene = document.edited_scene().map(|edited| {
        let scene = edited.scene();
        let nodes = scene.nodes().iter().enumerate().map(|(at, node)| {
            let shown = held || edited.node() != Some(at);
            let path = node.path().filter(|_| shown);
            let path = path.map(|follow| format!("{:?}", follow.path()));
            (node.name.clone(), node.parent, node.rest, path)
        });
        let nodes: Vec<_> = nodes.collect();
        let (markers, pins) = (scene.markers(), scene.pins());
        // What is pinned of the edited path, which the scene learns when another node is chosen.
        let pinned: Vec<_> = edited.pinned().collect();
        let shown = (scene.camera(), scene.range(), markers, pins, pinned);
        format!(
            "{:?} {:?} {nodes:?} {shown:?}",
            edited.node(),
            scene.space()
        )
    });
    format!("{:?} {:?} {scene:?}", document.path(), document.info())
}

fn assert_sound(document: &Document) {
    document.path().check().unwrap();
    document.info().check(document.path().space).unwrap();
    let Selection { point, orientation } = document.selection();
    assert!(orientation < document.path().points[point].orientations.len());
    for point in &document.path().points {
        for orientation in &point.orientations {
            assert!(orientation.roll > -180.0 && orientation.roll <= 180.0);
        }
    }
    let text = match document.to_toml() {
        Ok(text) => text,
        // Where a node of a scene is too late, its path can have too many frames for it.
        Err(error) => {
            assert!(document.edited_scene().is_some(), "{error}");
            assert_eq!(error.kind(), ErrorKind::Limit);
            return;
        }
    };
    if document.edited_scene().is_some() {
        let loaded = Document::scene_from_toml(&text, "".as_ref());
        let (loaded, _) = loaded.unwrap_or_else(|error| panic!("{error} in\n{text}"));
        assert_eq!(loaded.to_toml().unwrap(), text);
        return;
    }
    let loaded = Document::from_toml(&text).unwrap_or_else(|error| panic!("{error} in\n{text}"));
    assert_eq!(content(&loaded, true), content(document, true), "{text}");
    assert_eq!(loaded.to_toml().unwrap(), text);
}

/// What is kept up to date edit by edit is what is computed at once.
fn assert_computed(document: &Document) {
    let fresh = Document::from_parts(document.path().clone(), document.info().clone()).unwrap();
    let figures = |document: &Document| {
        document
            .timeline(|timeline| {
                let sections: Vec<_> = (0..timeline.section_count())
                    .map(|index| timeline.section(index))
                    .collect();
                let lengths: Vec<_> = (0..document.path().segment_count())
                    .map(|segment| timeline.segment_length(segment).to_bits())
                    .collect();
                (sections, lengths)
            })
            .unwrap()
    };
    assert_eq!(figures(document), figures(&fresh));
}

#[test]
fn no_edit_is_missing() {
    let mut document = Document::new();
    document.apply(Edit::AppendAfterLast).unwrap();
    for number in 0..KINDS {
        let (a, b, c, flag, x) = (1, 2, 3, true, [0.5; 6]);
        let raw = Raw {
            kind: number,
            a,
            b,
            c,
            flag,
            x,
        };
        assert_eq!(kind(&raw.edit(&document)), number);
    }
}

/// The node whose path is edited.
fn node(document: &Document) -> Option<Option<usize>> {
    document.edited_scene().map(|edited| edited.node())
}

/// Lets a node that was chosen go into a step.
fn settle(document: &mut Document) {
    let title = "settled".to_owned();
    let info = Info {
        title,
        ..document.info().clone()
    };
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_edits_can_be_undone_and_done_again(raws in prop::collection::vec(raw(), 1..40)) {
        let mut document = Document::new();
        let (mut befores, mut modified) = (Vec::new(), false);
        // What was there before another node was chosen.
        let mut away = None;
        assert_computed(&document);
        for raw in &raws {
            let before = whole(&document);
            if raw.kind == SELECT {
                let _ = document.select(raw.a % 4, raw.b % 2);
                prop_assert_eq!(content(&document, true), before.split(" Selection").next().unwrap());
                continue;
            }
            let content_before = content(&document, true);
            let edit = raw.edit(&document);
            let of = kind(&edit);
            if document.apply(edit).is_err() {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            assert_sound(&document);
            assert_computed(&document);
            if content(&document, true) == content_before && !matches!(of, 8 | 13 | 14 | 18 | 19 | 21) {
                prop_assert_eq!(whole(&document), before);
                continue;
            }
            // To choose a node is no step; it goes back with the next one.
            if of == 7 {
                away.get_or_insert(before);
                continue;
            }
            let before = away.take().unwrap_or(before);
            let after = whole(&document);
            prop_assert!(!document.can_redo());
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), before.clone());
            assert_computed(&document);
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), after);
            assert_computed(&document);
            befores.push(before);
            modified = true;
        }
        prop_assert_eq!(document.is_modified(), modified);
        let last = away.unwrap_or_else(|| whole(&document));
        let mut afters = vec![last];
        for before in befores.iter().rev() {
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), before.clone());
            afters.push(whole(&document));
        }
        prop_assert!(!document.undo());
        prop_assert!(!document.is_modified());
        afters.pop();
        for after in afters.into_iter().rev() {
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), after);
        }
        prop_assert!(!document.redo());
    }

    #[test]
    fn a_step_of_many_edits_is_one(
        before in prop::collection::vec(raw(), 0..8),
        within in prop::collection::vec(raw(), 0..30),
    ) {
        let mut document = Document::new();
        for raw in &before {
            let _ = document.apply(raw.edit(&document));
        }
        settle(&mut document);
        document.mark_saved();
        let start = whole(&document);
        document.begin_step();
        for raw in &within {
            let _ = document.apply(raw.edit(&document));
        }
        document.cancel_step();
        prop_assert_eq!(whole(&document), start.clone());
        prop_assert!(!document.is_modified());

        document.begin_step();
        let mut changed = false;
        for raw in &within {
            let modified = content(&document, true);
            let _ = document.apply(raw.edit(&document));
            changed |= content(&document, true) != modified;
        }
        document.end_step();
        if changed {
            let end = whole(&document);
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), start);
            prop_assert!(!document.is_modified());
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), end);
            assert_computed(&document);
        }
    }

    #[test]
    fn edits_together_are_done_all_or_none(
        before in prop::collection::vec(raw(), 0..8),
        within in prop::collection::vec(raw(), 0..4),
        together in prop::collection::vec(raw(), 0..6),
        part in any::<bool>(),
    ) {
        let mut document = Document::new();
        for raw in &before {
            let _ = document.apply(raw.edit(&document));
        }
        settle(&mut document);
        // Of what there is now: later ones may find no point of theirs.
        let edits: Vec<Edit> = together.iter().map(|raw| raw.edit(&document)).collect();
        let (start, first) = (whole(&document), node(&document));
        document.mark_saved();
        if part {
            document.begin_step();
            for raw in &within {
                let _ = document.apply(raw.edit(&document));
            }
        }
        let middle = whole(&document);
        let mut one_by_one = document.try_clone().unwrap();
        let possible = edits.iter().all(|edit| one_by_one.apply(edit.clone()).is_ok());
        prop_assert_eq!(document.apply_all(edits).is_ok(), possible);
        prop_assert_eq!(document.in_step(), part);
        let end = if possible { whole(&one_by_one) } else { middle };
        prop_assert_eq!(whole(&document), end.clone());
        assert_computed(&document);
        document.end_step();
        // Another node to edit is a step, but not one that a file would show.
        if document.is_modified() || node(&document) != first {
            prop_assert!(document.undo());
            prop_assert_eq!(whole(&document), start);
            prop_assert!(!document.is_modified());
            prop_assert!(document.redo());
            prop_assert_eq!(whole(&document), end);
        } else {
            prop_assert_eq!(whole(&document), start);
        }
    }

    #[test]
    fn without_history_the_same_is_done(raws in prop::collection::vec(raw(), 1..30)) {
        let mut with = Document::new();
        let mut without = Document::new().without_history();
        for raw in &raws {
            let a = with.apply(raw.edit(&with)).map_err(|error| error.to_string());
            let b = without.apply(raw.edit(&without)).map_err(|error| error.to_string());
            prop_assert_eq!(a, b);
            // A node that is left and chosen again has never been left where there is a history.
            prop_assert_eq!(content(&with, false), content(&without, false));
            prop_assert_eq!(with.selection(), without.selection());
            prop_assert_eq!(with.is_modified(), without.is_modified());
        }
        prop_assert!(!without.can_undo());
        prop_assert!(!without.undo());
        let copy = with.try_clone().unwrap();
        prop_assert_eq!(whole(&copy), whole(&with));
        prop_assert_eq!(copy.is_modified(), with.is_modified());
        prop_assert!(!copy.can_undo());
    }
}

/// A node's path may have a larger space than its scene, by whose space files are read.
#[test]
fn an_object_lies_in_the_scenes_space_too() {
    let mut path = CameraPath::default();
    path.space.half_size = 1e5;
    let mut node = Node::new("a", scene::Kind::Group);
    let path = FollowPath::new(path, 1.0, Extrapolation::Hold).unwrap();
    node.set_path(Some(path)).unwrap();
    let mut scene = Scene::new();
    scene.add(node).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let _ = document.apply(Edit::EditNode(Some(0)));
    assert_eq!(document.path().space.half_size, 1e5);
    let before = whole(&document);
    let mut info = document.info().clone();
    let position = DVec3::splat(1e10);
    info.object = vec![ObjectPoint {
        position,
        draw: true,
    }]
    .into();
    let error = document.apply(Edit::SetInfo(Box::new(info))).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
    assert_eq!(whole(&document), before);
    assert_sound(&document);
}

#[test]
fn no_node_is_edited_in_whose_space_the_object_would_be_too_far_away() {
    let mut scene = Scene::new();
    let far = Space {
        half_size: 1e6,
        ..Space::default()
    };
    scene.set_space(far).unwrap();
    for (name, half_size) in [("far", 1e6), ("near", 1.0)] {
        let mut path = CameraPath::default();
        path.space.half_size = half_size;
        let mut node = Node::new(name, scene::Kind::Group);
        let path = FollowPath::new(path, 1.0, Extrapolation::Hold).unwrap();
        node.set_path(Some(path)).unwrap();
        scene.add(node).unwrap();
    }
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let _ = document.apply(Edit::EditNode(Some(0)));
    let mut info = Info::default();
    let position = DVec3::splat(1e14);
    info.object = vec![ObjectPoint {
        position,
        draw: true,
    }]
    .into();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    let before = whole(&document);
    let error = document.apply(Edit::EditNode(Some(1))).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
    assert_eq!(whole(&document), before);
}
