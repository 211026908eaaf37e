//! Tests of [`super`].

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use vides_document::Edit;

use super::*;
use crate::screenshots::screenshot;
use crate::space::tests::{pyramid_window, tap};

/// Opens the menu, switches this and closes it.
fn choose(harness: &mut Harness<'_, Editor>, name: &str) {
    let button = harness.state().texts().space.plot;
    harness.get_by_label(button).click();
    harness.run();
    harness
        .get_by_role_and_label(egui::Role::CheckBox, name)
        .click();
    harness.run();
    tap(harness, egui::Key::Escape, egui::Modifiers::NONE);
    harness.run();
}

fn last(harness: &Harness<'_, Editor>, quantity: Quantity) -> f64 {
    let curves = &harness.state().playing.plot.curves;
    let curve = curves.iter().find(|curve| curve.quantity == quantity);
    curve.unwrap().at(1e9).unwrap()
}

#[test]
fn quantities_are_shown_over_one_another_and_follow_the_path() {
    let mut harness = pyramid_window();
    let texts = &crate::Language::English.texts().space;
    for (number, (name, quantity)) in [
        (texts.plot_speed, Quantity::Speed),
        (texts.plot_turning, Quantity::Turning),
        (texts.plot_zoom, Quantity::Zoom),
    ]
    .into_iter()
    .enumerate()
    {
        choose(&mut harness, name);
        let playing = &harness.state().playing;
        assert!(playing.shown.has(Some(quantity)) && playing.shown.pace);
        assert_eq!(playing.plot.curves.len(), number + 1);
        let long = |curve: &Curve| curve.values.len() > 700;
        assert!(playing.plot.curves.iter().all(long));
        screenshot(&mut harness, &format!("plot-{name}.png"));
    }
    // The zoom of all is 24; at the end it is another.
    assert_eq!(last(&harness, Quantity::Zoom), 24.0);
    let points = harness.state().document.path().points.len();
    harness.state_mut().document.select(points - 1, 0).unwrap();
    harness.state_mut().set_orientation(|last| last.zoom = 50.0);
    harness.run();
    assert_eq!(last(&harness, Quantity::Zoom), 50.0);
    tap(&mut harness, egui::Key::Z, egui::Modifiers::CTRL);
    harness.run();
    assert_eq!(last(&harness, Quantity::Zoom), 24.0);
    // What is switched off last gives way to the pace.
    for name in [
        texts.speed_graph,
        texts.plot_speed,
        texts.plot_turning,
        texts.plot_zoom,
    ] {
        choose(&mut harness, name);
    }
    let playing = &harness.state().playing;
    assert_eq!(playing.shown, Shown::default());
    assert!(playing.plot.curves.is_empty());
}

/// The pyramid is an object; the way is as long as its parts.
#[test]
fn distance_and_clearance_are_those_of_the_poses() {
    let mut harness = pyramid_window();
    let texts = &crate::Language::English.texts().space;
    choose(&mut harness, texts.plot_distance);
    choose(&mut harness, texts.plot_clearance);
    let editor = harness.state();
    let sampler = editor.document.sampler().unwrap();
    let place = |frame: f64| DVec3::from_array(sampler.pose(frame).unwrap().vrp);
    let frames = sampler.frame_count() as u32;
    let steps = (1..frames).map(f64::from);
    let way: f64 = steps.map(|k| place(k).distance(place(k + 1.0))).sum();
    // No line of the object is far from one of these.
    let lines = editor.document.info().object.lines();
    let end = place(f64::from(frames));
    let places = lines.flat_map(|(ends, _)| {
        (0..=1000).map(move |k| ends[0].lerp(ends[1], f64::from(k) / 1000.0))
    });
    let near = places.map(|on| on.distance(end)).fold(f64::MAX, f64::min);
    for (quantity, expected) in [(Quantity::Distance, way), (Quantity::Clearance, near)] {
        let shown = last(&harness, quantity);
        assert!(
            (shown - expected).abs() < 1e-5,
            "{quantity:?}: {shown} {expected}"
        );
    }
    screenshot(&mut harness, "plot-way.png");
}

/// A limit is a line where the curve comes near it, and none where it is off or far away.
#[test]
fn limits_are_lines_in_the_unit_of_their_quantity() {
    let mut harness = pyramid_window();
    let texts = &crate::Language::English.texts().space;
    choose(&mut harness, texts.plot_turning);
    choose(&mut harness, texts.plot_acceleration);
    choose(&mut harness, texts.plot_speed);
    choose(&mut harness, texts.speed_graph);
    let limits = |harness: &Harness<'_, Editor>| {
        let editor = harness.state();
        let all = editor.playing.plot.curves.iter();
        all.map(|curve| (curve.quantity, limit(&editor.document, curve)))
            .collect::<Vec<_>>()
    };
    let half = harness.state().document.path().space.half_size;
    let curves = &harness.state().playing.plot.curves;
    let highest: Vec<f64> = curves.iter().map(|curve| curve.range(None).1).collect();
    for (factor, shown) in [(0.5, true), (2.0, true), (4.0, false)] {
        let mut info = harness.state().document.info().clone();
        let kinds = [FindingKind::Speed, FindingKind::Acceleration];
        for (kind, high) in kinds.into_iter().zip(&highest) {
            info.limits.set(kind, factor * high / half).unwrap();
        }
        info.limits.set(FindingKind::Turning, OFF).unwrap();
        let editor = harness.state_mut();
        editor
            .document
            .apply(Edit::SetInfo(Box::new(info)))
            .unwrap();
        harness.run();
        let found = limits(&harness);
        for (&(quantity, limit), high) in found.iter().zip(&highest) {
            let expected = (shown && quantity != Quantity::Turning).then_some(factor * high);
            let same = match (limit, expected) {
                (Some(a), Some(b)) => (a - b).abs() < 1e-9 * b,
                (a, b) => a == b,
            };
            assert!(same, "{quantity:?} {factor}: {limit:?} {expected:?}");
        }
        screenshot(&mut harness, &format!("plot-limits-{factor}.png"));
    }
}

/// Over the pace alone a hint tells what it is; over curves their values are read at the pointer.
#[test]
fn the_graph_is_read_at_the_pointer() {
    use crate::tests::{BOTH, window};
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        let (canvas, name) = (egui::Role::Canvas, texts.space.speed_graph);
        for quantity in [None].into_iter().chain(Quantity::ALL.map(Some)) {
            let context = window.ctx.clone();
            window.state_mut().playing.shown = Shown::default();
            if let Some(quantity) = quantity {
                let action = Action::Time(TimeAction::Plot(Some(quantity)));
                window.state_mut().act(action, &context);
            }
            window.run();
            let plot = window.get_by_role_and_label(canvas, name).rect();
            let pointer = plot.center() + vec2(0.0, 16.0);
            window.hover_at(pointer);
            for _ in 0..80 {
                window.step();
            }
            let hint = window.query_by_label(told(texts, None)).is_some();
            assert_eq!(hint, quantity.is_none());
            let editor = window.state();
            let Some(curve) = editor.playing.plot.curves.first() else {
                continue;
            };
            // The rail is eight points shorter at both sides.
            let rail = plot.x_range().shrink(8.0);
            let share = f64::from((pointer.x - rail.min) / rail.span());
            let frames = editor.playing.marks.frames as f64;
            let value = curve.at(1.0 + share * (frames - 1.0));
            let value = value.map(|value| with_unit(editor, curve.quantity, value));
            let all = names(texts);
            let (_, name) = all.iter().find(|(of, _)| *of == quantity).unwrap();
            let words = format!("{name} {}", value.unwrap_or_default());
            let shapes = &window.output().shapes;
            let told = |shape: &egui::Shape| match shape {
                Shape::Text(text) => text.galley.text().starts_with(&words),
                _ => false,
            };
            assert!(shapes.iter().any(|clipped| told(&clipped.shape)), "{words}");
            window.hover_at(pos2(1.0, 799.0));
            window.run();
        }
    }
}

#[test]
fn colours_of_the_curves_stand_out_on_their_ground() {
    for theme in [crate::setup::Theme::Dark, crate::setup::Theme::Light] {
        let palette = theme.palette();
        for quantity in Quantity::ALL {
            // They are written in this colour, too.
            let found = theme::contrast(colour(palette, Some(quantity)), palette.field);
            assert!(found >= 4.5, "{quantity:?}: {found}");
        }
    }
}
