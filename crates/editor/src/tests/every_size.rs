//! Nothing is cut and nothing lies over something else, read off the rectangles of all controls, in
//! every size, scale, theme and language.

use egui_kittest::kittest::{NodeT, by};
use vides_document::tool;

use super::*;
use crate::action::{Action, ToolAction};

/// In pixels.
const SIZES: [[f32; 2]; 6] = [
    [800.0, 600.0],
    [1024.0, 768.0],
    [1200.0, 800.0],
    [1920.0, 1080.0],
    [2560.0, 1440.0],
    [3840.0, 2160.0],
];
const SCALES: [f32; 4] = [1.0, 1.5, 2.0, 3.0];

/// What is pressed, typed into or dragged, and no surface on which others lie.
const CONTROLS: [Role; 7] = [
    Role::Button,
    Role::TextInput,
    Role::SpinButton,
    Role::CheckBox,
    Role::RadioButton,
    Role::ComboBox,
    Role::MenuItem,
];

/// Width of the panels, which scroll.
const PANELS: f32 = 262.0;

/// The least between the panels and the fields below them.
const GAP: f32 = 2.0;

/// Names and places of all controls, as far as they are seen.
fn controls(window: &Window) -> Vec<(String, egui::Rect)> {
    let texts = window.state().texts();
    let below = window.get_by_label(texts.space.rate).rect().top() - GAP;
    let left = window.ctx.content_rect().right() - PANELS;
    let all = window.query_all(by().predicate(|node| CONTROLS.contains(&node.role())));
    let placed = all.filter(|node| node.accesskit_node().bounding_box().is_some());
    let named = placed.map(|node| {
        let name = node.accesskit_node().label().unwrap_or_default();
        let mut rect = node.rect();
        if rect.left() >= left && rect.top() < below {
            rect.max.y = rect.max.y.min(below);
        }
        (name, rect)
    });
    named.filter(|(_, rect)| rect.is_positive()).collect()
}

/// What lies beyond the window, or over another control.
fn faults(window: &Window) -> Vec<String> {
    let whole = window.ctx.content_rect().expand(1.0);
    let all = controls(window);
    // The ends of the axes turn round one another; the nearest one is meant.
    let texts = window.state().texts();
    let words = texts
        .menu_hints
        .view_along
        .split('{')
        .next()
        .unwrap_or_default();
    let axis = |name: &str| name.starts_with(words);
    let mut faults = Vec::new();
    for (at, (name, rect)) in all.iter().enumerate() {
        if !whole.contains_rect(*rect) {
            faults.push(format!("{name} {rect:?} beyond the window"));
        }
        for (other, over) in &all[at + 1..] {
            if axis(name) && axis(other) {
                continue;
            }
            if rect.shrink(1.0).intersects(over.shrink(1.0)) {
                faults.push(format!("{name} {rect:?} over {other} {over:?}"));
            }
        }
    }
    faults
}

#[test]
fn nothing_is_cut_and_nothing_lies_over_something_else() {
    let (mut looks, mut seen, mut told) = (0, 0, Vec::new());
    for [width, height] in SIZES {
        for scale in SCALES {
            let size = [width / scale, height / scale];
            if size[0] < 640.0 || size[1] < 440.0 {
                continue;
            }
            for language in BOTH {
                for theme in [Theme::Dark, Theme::Light] {
                    for what in ["empty", "points", "beside", "tool"] {
                        let mut window = match what {
                            "empty" => window_of(options(language), size, scale, theme),
                            _ => window_with_points(language, size, scale, theme),
                        };
                        if what == "beside" {
                            press(&mut window, Modifiers::NONE, Key::B);
                        }
                        // A lower window scrolls it.
                        if what == "tool" && size[1] > 700.0 {
                            let orbit = tool::tools().next().expect("a move");
                            let context = window.ctx.clone();
                            window
                                .state_mut()
                                .act(Action::Tool(ToolAction::Open(orbit)), &context);
                            window.run();
                        }
                        looks += 1;
                        seen += controls(&window).len();
                        for fault in faults(&window) {
                            told.push(format!("{size:?} {scale} {language:?} {what}: {fault}"));
                        }
                    }
                }
            }
        }
    }
    println!("{looks} looks, {seen} controls, {} faults", told.len());
    assert!(looks > 150 && seen > 40 * looks);
    assert!(told.is_empty(), "{}", told.join("\n"));
}
