//! What can be said of the window's looks without looking: every letter has a
//! picture, numbers stand in columns, nothing is cut off.

use egui::Id;
use egui_kittest::kittest::{NodeT, by};

use super::words::painted;
use super::*;
use crate::action::{Action, FileAction, PathAction, ToolAction};
use crate::screenshots::screenshot;
use crate::theme;

#[test]
fn digits_are_of_equal_width() {
    let window = window(Language::German);
    let widths: Vec<f32> = ('0'..='9')
        .map(|digit| {
            window
                .ctx
                .fonts_mut(|fonts| fonts.glyph_width(&theme::text(), digit))
        })
        .collect();
    assert!(widths[0] > 4.0);
    assert!(widths.iter().all(|&width| width == widths[0]), "{widths:?}");
}

/// Whatever has a name lies within the window, to a border's width.
fn check_nothing_is_cut_off(window: &Window, when: &str) {
    let cut = cut_off(window);
    assert!(cut.is_empty(), "{when}: {cut:?}");
}

/// What does not lie within the window, and where it is.
fn cut_off(window: &Window) -> Vec<(String, egui::Rect)> {
    let whole = window.ctx.content_rect();
    let named = window.query_all(by().predicate(|node| node.label().is_some()));
    // What is scrolled out of sight may have no place.
    let placed = named.filter(|node| node.accesskit_node().bounding_box().is_some());
    let all = placed.map(|node| {
        (
            node.accesskit_node().label().unwrap_or_default(),
            node.rect(),
        )
    });
    let all = Vec::from_iter(all);
    assert!(all.len() > 20, "{}", all.len());
    let cut = |(_, rect): &(_, egui::Rect)| !whole.expand(1.0).contains_rect(*rect);
    all.into_iter().filter(cut).collect()
}

#[test]
fn nothing_is_cut_off_in_the_smallest_window() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window_with_points(language, SMALL, 1.0, Theme::Dark);
        check_nothing_is_cut_off(&window, "at first");
        for action in ["far", "roll"] {
            let (name, text) = match action {
                "far" => (fill(texts.position.coordinate, &[&"x"]), "-0.999"),
                _ => (texts.orientation.roll.to_owned(), "-179.9"),
            };
            enter(&mut window, &name, text);
            check_nothing_is_cut_off(&window, action);
        }
        for (key, menu) in [(Key::D, "file"), (Key::A, "output"), (Key::E, "settings")] {
            press(&mut window, Modifiers::ALT, key);
            check_nothing_is_cut_off(&window, menu);
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        click(&mut window, texts.menu.edit);
        check_nothing_is_cut_off(&window, "edit");
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::CTRL, Key::I);
        check_nothing_is_cut_off(&window, "points");
        press(&mut window, Modifiers::NONE, Key::Escape);
        let context = window.ctx.clone();
        window.state_mut().act(Action::Space, &context);
        window.run();
        check_nothing_is_cut_off(&window, "space");
        press(&mut window, Modifiers::NONE, Key::Escape);
        window.state_mut().ask_to_close();
        window.run();
        check_nothing_is_cut_off(&window, "question");
    }
}

/// In the smallest window the curve window and the speed window leave most of
/// the movement window to be seen, lie within the window, and can be moved.
#[test]
fn sub_windows_leave_the_movement_window_to_be_seen() {
    for language in BOTH {
        let texts = language.texts();
        for (key, id) in [(Key::F2, "curve"), (Key::F3, "speed")] {
            let mut window = window_with_points(language, SMALL, 1.0, Theme::Dark);
            let mut space = window.get_by_label(texts.space.name).rect();
            press(&mut window, Modifiers::NONE, key);
            let area = |window: &Window| {
                let area = window.ctx.memory(|memory| memory.area_rect(Id::unique(id)));
                area.expect("an open window")
            };
            let at = area(&window);
            assert!(window.ctx.content_rect().contains_rect(at), "{id}: {at:?}");
            let docked = window.state().windows.dock_place().is_some();
            if docked {
                space = window.get_by_label(texts.space.name).rect();
            }
            let hidden = at.intersect(space).area() / space.area();
            assert!(hidden < 0.5, "{id} hides {hidden} of the movement window");
            if docked {
                // It scrolls.
                continue;
            }
            check_nothing_is_cut_off(&window, id);
            let title = at.center_top() + vec2(0.0, 14.0);
            window.hover_at(title);
            window.run();
            window.drag_at(title);
            window.run();
            window.hover_at(title + vec2(-120.0, 40.0));
            window.run();
            window.drop_at(title + vec2(-120.0, 40.0));
            window.run();
            let moved = area(&window).min - at.min;
            assert!(moved.x < -50.0 && moved.y > 10.0, "{id}: {moved:?}");
            assert!(
                window.ctx.content_rect().contains_rect(area(&window)),
                "{id}"
            );
        }
    }
}

/// In the smallest window the output field still says what each number is.
#[test]
fn the_output_field_keeps_its_labels() {
    for language in BOTH {
        let texts = &language.texts().output;
        let window = window_with_points(language, SMALL, 1.0, Theme::Dark);
        let mut texts_of_bar = Vec::new();
        for shape in &window.output().shapes {
            if let egui::Shape::Text(text) = &shape.shape
                && text.pos.y < 32.0
            {
                let rect = egui::Rect::from_min_size(text.pos, text.galley.size());
                texts_of_bar.push((text.galley.text().to_owned(), rect));
            }
        }
        for label in [
            texts.point,
            texts.position,
            texts.view,
            texts.roll,
            texts.zoom,
        ] {
            assert!(
                texts_of_bar.iter().any(|(text, _)| text == label),
                "{label}"
            );
        }
        for (index, (one, a)) in texts_of_bar.iter().enumerate() {
            assert!(a.top() >= 0.0 && a.bottom() <= 32.0, "{one}: {a:?}");
            for (other, b) in &texts_of_bar[index + 1..] {
                // Lines of text touch; letters do not.
                let both = a
                    .shrink2(vec2(0.0, 2.0))
                    .intersects(b.shrink2(vec2(0.0, 2.0)));
                assert!(!both, "{one} {a:?} over {other} {b:?}");
            }
        }
    }
}

#[test]
fn columns_do_not_jump() {
    let mut window = window(Language::German);
    let places = |window: &Window| -> Vec<f32> {
        // Where each text of the bar ends.
        let shapes = &window.output().shapes;
        let mut ends = Vec::new();
        for shape in shapes {
            if let egui::Shape::Text(text) = &shape.shape
                && text.pos.y < 32.0
                && text
                    .galley
                    .text()
                    .ends_with(|letter: char| letter.is_ascii_digit() || letter == '°')
            {
                ends.push(text.pos.x + text.galley.size().x);
            }
        }
        ends
    };
    let before = places(&window);
    assert_eq!(before.len(), 9, "{before:?}");
    for (name, text) in [
        ("Position x", "0,777"),
        ("Rollen", "-123,4"),
        ("Zoomwert", "8"),
    ] {
        enter(&mut window, name, text);
        // In place of what is said of the length.
        window.state_mut().message = None;
        window.run();
        let after = places(&window);
        assert_eq!(after.len(), before.len());
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() < 0.51, "{name}: {before} {after}");
        }
    }
}

/// What stands in a column ends where the column ends.
#[test]
fn the_buttons_of_a_file_window_end_where_its_fields_end() {
    for language in BOTH {
        let texts = &language.texts().files;
        let mut window = window(language);
        press(&mut window, Modifiers::ALT, Key::S);
        let save = window.get_by_role_and_label(Role::Button, texts.save);
        let name = window.get_by_role_and_label(Role::TextInput, texts.name);
        let (button, field) = (save.rect().right(), name.rect().right());
        assert!((button - field).abs() < 1.0, "{button} {field}");
    }
}

#[test]
fn the_colours_numbers_end_where_the_window_does() {
    for language in BOTH {
        let mut window = window(language);
        open_menu(&mut window, 4);
        click(&mut window, language.texts().menu.colours);
        let id = Id::unique("colours");
        let area = window.ctx.memory(|memory| memory.area_rect(id));
        let margin = window.ctx.global_style().spacing.window_margin.rightf();
        let end = area.expect("an open window").right() - margin;
        let texts = &language.texts().colours;
        for name in [texts.red, texts.green, texts.blue] {
            let number = number(&window, name).rect().right();
            assert!((end - number).abs() < 2.0, "{name}: {number} {end}");
        }
    }
}

/// Also around a button that has the colour of the border.
#[test]
fn what_has_the_keyboard_has_a_border() {
    for theme in [Theme::Dark, Theme::Light] {
        let mut window = window_of(options(Language::English), LARGE, 1.0, theme);
        let label = Language::English.texts().orientation.absolute;
        window.get_by_label(label).focus();
        window.run();
        // By a key.
        press(&mut window, Modifiers::NONE, Key::Tab);
        press(&mut window, Modifiers::SHIFT, Key::Tab);
        assert!(window.get_by_label(label).is_focused());
        let button = window.get_by_label(label).rect();
        let picture = window.render().expect("a picture");
        let colours = theme.palette();
        for at in [
            button.center_top() - vec2(0.0, 1.0),
            button.left_center() - vec2(1.0, 0.0),
        ] {
            let seen = picture.get_pixel(at.x as u32, at.y as u32).0;
            assert_eq!(seen, colours.focus.to_array(), "{theme:?}");
            assert!(theme::contrast(colours.focus, colours.panel) >= 3.0);
        }
    }
}

/// The texts of the panels with their places.
fn texts_of_panels(window: &Window) -> Vec<(String, egui::Rect)> {
    let shapes = window.output().shapes.iter();
    let texts = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) if text.pos.x > LARGE[0] - 250.0 && text.pos.y > 32.0 => {
            let rect = egui::Rect::from_min_size(text.pos, text.galley.size());
            Some((text.galley.text().to_owned(), rect))
        }
        _ => None,
    });
    texts.filter(|(text, _)| !text.is_empty()).collect()
}

/// However far away a point lies, however many frames a section takes.
#[test]
fn no_text_of_the_panels_lies_over_another() {
    let orientation = |x: f64| Orientation {
        target: Target::Absolute(DVec3::new(x, 0.0, 0.0)),
        roll: -179.9,
        hold: 1_000_000,
        ..Orientation::default()
    };
    let far = [1e9, -1e9, 123_456.789, -999_999.5];
    let path = |x: f64, y: f64| vides_engine::path::CameraPath {
        points: [[0.0; 3], [x, y, -x]]
            .map(|place| {
                let mut point = vides_engine::path::SupportPoint::new(DVec3::from_array(place));
                point.orientations = vec![orientation(0.5), orientation(0.5)];
                if place[0] != 0.0 {
                    // One that owns what there is to own.
                    let own = DVec3::X;
                    let tangents = vides_engine::path::Tangents {
                        before: own,
                        after: own,
                    };
                    point.tangents = Some(tangents);
                    let key = &mut point.orientations[1];
                    let own = key.own.with(|own| {
                        own.zoom_slope = Some(0.1);
                        own.roll_slope = Some(0.1);
                    });
                    key.own = own.expect("memory");
                }
                point
            })
            .into(),
        ..vides_engine::path::CameraPath::default()
    };
    for language in BOTH {
        for (x, y) in far.map(|x| (x, -x)).into_iter().chain([(1000.0, 0.1)]) {
            let path = path(x, y);
            let document = Document::from_parts(path, vides_document::Info::default());
            let options = Options {
                document: document.expect("a path"),
                ..options(language)
            };
            let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
            let mut seen = 0;
            // A pan in which nothing changes; a long way; the end of the path.
            for (point, orientation) in [(0, 0), (0, 1), (1, 1)] {
                window.state_mut().select(point, orientation);
                window.run();
                let texts = texts_of_panels(&window);
                seen += texts.len();
                for (index, (one, a)) in texts.iter().enumerate() {
                    assert!(a.right() <= LARGE[0] - 12.0, "{one} {a:?}");
                    for (other, b) in &texts[index + 1..] {
                        let both = a.shrink(1.0).intersects(b.shrink(1.0));
                        assert!(!both, "{x}: {one} {a:?} over {other} {b:?}");
                    }
                }
            }
            assert!(seen > 90, "{seen}");
            // The whole value is still told.
            let name = fill(language.texts().position.coordinate, &[&"x"]);
            assert_eq!(value(&window, &name), language.number(x, 3));
        }
    }
}

/// What has no room in its field is told beside the pointer.
#[test]
fn a_shortened_number_is_told_whole_by_its_tooltip() {
    let mut window = window(Language::English);
    enter(&mut window, "Position x", "1000000000");
    let at = number(&window, "Position x").rect().center();
    window.hover_at(at);
    for _ in 0..4 {
        window.step();
    }
    let shown = painted(&window.output().shapes);
    let whole = |text: &String| text.starts_with("Position x 1000000000.000");
    assert!(shown.iter().any(whole), "{shown:?}");
    assert!(shown.iter().any(|text| text == "1.00e9"), "{shown:?}");
}

/// That of the movement window touches the field of the tilt.
#[test]
fn the_border_of_what_has_the_keyboard_covers_no_neighbour() {
    for size in [SMALL, LARGE] {
        let options = Options {
            fixed_speeds: true,
            ..options(Language::English)
        };
        let mut window = window_of(options, size, 1.0, Theme::Dark);
        let texts = &Language::English.texts().space;
        let around = |window: &mut Window| {
            let fields = [texts.tilt, texts.rotate, texts.size];
            let fields = fields.map(|name| {
                let all = window.get_all_by_role_and_label(Role::SpinButton, name);
                all.last().expect("a number").rect()
            });
            let picture = window.render().expect("a picture");
            let mut pixels = Vec::new();
            for rect in fields {
                for y in rect.top() as u32..rect.bottom() as u32 {
                    let row = rect.left() as u32..rect.right() as u32;
                    pixels.extend(row.map(|x| picture.get_pixel(x, y).0));
                }
            }
            pixels
        };
        window.get_by_label(texts.name).focus();
        window.run();
        let before = around(&mut window);
        // The arrow keys turn the space and bring the border.
        let view = window.state().setup.view;
        press(&mut window, Modifiers::COMMAND, Key::ArrowRight);
        assert_ne!(window.state().setup.view, view);
        window.state_mut().setup.view = view;
        window.run();
        let room = window.get_by_label(texts.name).rect();
        let picture = window.render().expect("a picture");
        let colour = Theme::Dark.palette().focus.to_array();
        let at = room.left_center() + vec2(1.0, 40.0);
        assert_eq!(picture.get_pixel(at.x as u32, at.y as u32).0, colour);
        assert!(around(&mut window) == before, "{size:?}");
    }
}

/// Where a tooltip would lie over a window to which it does not belong, there is none.
#[test]
fn no_tooltip_covers_a_dialog() {
    let texts = Language::English.texts();
    let shown = |window: &mut Window| {
        let at = window.get_by_label(texts.points_list.fold).rect();
        window.hover_at(at.left_center() + vec2(12.0, 0.0));
        for _ in 0..80 {
            window.step();
        }
        let shown = painted(&window.output().shapes);
        let shown = shown.iter().any(|text| text == texts.points_list.fold);
        window.hover_at(egui::pos2(600.0, 400.0));
        window.run();
        shown
    };
    let mut window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
    assert!(shown(&mut window));
    press(&mut window, Modifiers::NONE, Key::F2);
    assert!(!shown(&mut window));
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(shown(&mut window));
}

/// A screen of 1400 × 900 at twice the size leaves 700 × 450 points.
#[test]
fn nothing_is_cut_off_at_twice_the_size() {
    const SIZE: [f32; 2] = [700.0, 450.0];
    for language in BOTH {
        let mut window = window_with_points(language, SIZE, 2.0, Theme::Light);
        let mut cut = Vec::new();
        let mut look = |window: &mut Window, when: &str| {
            screenshot(window, &format!("twice-{language:?}-{when}.png"));
            let areas = |wanted: egui::Order| {
                window.ctx.memory(|memory| {
                    let all = memory.areas().visible_layer_ids().into_iter();
                    let all = all.filter(|layer| layer.order == wanted);
                    Vec::from_iter(all.filter_map(|layer| memory.area_rect(layer.id)))
                })
            };
            // Menus and windows as a whole; what lies in a window scrolls, and so do the panels.
            let mut scrolling = areas(egui::Order::Middle);
            let whole = window.ctx.content_rect().expand(1.0);
            for rect in areas(egui::Order::Foreground).iter().chain(&scrolling) {
                assert!(whole.contains_rect(*rect), "{when}: {rect:?}");
            }
            scrolling.push(egui::Rect::everything_right_of(SIZE[0] - 250.0));
            let scrolls = |rect: egui::Rect| {
                let within = |outer: &egui::Rect| {
                    let across = outer.x_range().expand(1.0);
                    across.contains(rect.left()) && across.contains(rect.right())
                };
                scrolling.iter().any(within)
            };
            let found = cut_off(window).into_iter();
            let found = found.filter(|(_, rect)| !scrolls(*rect));
            cut.extend(found.map(|found| (when.to_owned(), found)));
        };
        look(&mut window, "first");
        for (letter, _) in crate::menu::letters(language, false) {
            press(&mut window, Modifiers::ALT, letter);
            look(&mut window, letter.name());
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        let context = window.ctx.clone();
        let tools = vides_document::tool::tools()
            .map(|tool| (tool.name, Action::Tool(ToolAction::Open(tool))));
        let needs_file = ["insert", "blend", "fit"];
        let tools = tools.filter(|(name, _)| !needs_file.contains(name));
        let windows = [
            ("curve", Action::Curve),
            ("speed", Action::SpeedCurve),
            ("colours", Action::Colours),
            ("display", Action::Display),
            ("points", Action::Path(PathAction::AskPoints)),
            ("space", Action::Space),
            ("keys", Action::Keys),
            ("check", Action::Check),
            ("load", Action::File(FileAction::Load)),
            ("save", Action::File(FileAction::SaveAs)),
            ("export", Action::File(FileAction::Export)),
        ];
        for (name, action) in windows.into_iter().chain(tools) {
            window.state_mut().act(action, &context);
            window.run();
            look(&mut window, name);
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        let append = Edit::AppendAfterLast;
        window.state_mut().act(Action::Edit(append), &context);
        window.run();
        look(&mut window, "length");
        window.state_mut().ask_to_close();
        window.run();
        look(&mut window, "question");
        assert!(cut.is_empty(), "{cut:#?}");
    }
}
