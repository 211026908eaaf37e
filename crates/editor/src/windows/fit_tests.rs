//! The window in which recorded poses are fitted.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use vides_engine::path::Up;

use crate::action::{Action, FileAction};
use crate::screenshots::screenshot;
use crate::tests::*;

/// Quarter of a circle of radius 3 in 8 seconds with 30 poses a second, each coordinate off by at
/// most `noise`; those of `outliers` are 0.5 higher.
fn recorded(folder: &Path, noise: f64, outliers: &[usize]) -> PathBuf {
    let mut seed = 1_u64;
    let mut random = || {
        // Marsaglia's xorshift.
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / 2f64.powi(52) - 1.0
    };
    let mut text = String::new();
    for k in 0..240 {
        let turn = f64::from(k) / 240.0 * std::f64::consts::FRAC_PI_2;
        let high = if outliers.contains(&(k as usize)) {
            0.5
        } else {
            0.0
        };
        let [x, y, z] = [3.0 * turn.sin(), high, 3.0 * turn.cos()].map(|at| at + noise * random());
        let [sin, cos] = [(0.5 * turn).sin(), (0.5 * turn).cos()];
        let time = f64::from(k) / 30.0;
        writeln!(text, "{time:.6} {x:.9} {y:.9} {z:.9} 0 {sin:.9} 0 {cos:.9}").unwrap();
    }
    let file = folder.join("recorded.tum");
    std::fs::write(&file, text).expect("written");
    file
}

fn imported(window: &mut Window, file: &Path) {
    let context = window.ctx.clone();
    let action = FileAction::ImportUpright(file.to_owned(), Up::Y);
    window.state_mut().act(Action::File(action), &context);
    window.run();
}

fn points(window: &Window) -> usize {
    window.state().document.path().points.len()
}

fn report(window: &Window) -> vides_engine::tools::fit::Report {
    let tool = window.state().windows.tool.as_ref().expect("a window");
    tool.fit.as_ref().expect("a fit").report.clone()
}

/// The greatest distance of the shown path from the recorded circle, at its own frames.
fn off_circle(window: &Window) -> f64 {
    let off = poses(window.state()).into_iter().map(|pose| {
        let [x, y, z] = pose.vrp;
        (x.hypot(z) - 3.0).hypot(y)
    });
    off.fold(0.0, f64::max)
}

#[test]
fn an_import_shows_deviations_and_keeps_the_usual_tolerance() {
    for language in BOTH {
        let folder = tempfile::tempdir().expect("a folder");
        let file = recorded(folder.path(), 0.0, &[]);
        let mut window = window(language);
        imported(&mut window, &file);
        let texts = &language.texts().fit;
        for graph in [texts.position_graph, texts.view_graph] {
            assert!(window.query_by_label(graph).is_some(), "{graph}");
        }
        let report = report(&window);
        assert_eq!((report.poses, report.points), (240, points(&window)));
        // The diagonal of the positions' bounds is 3 √2, but for the last step.
        assert!(report.position.greatest <= 0.003 * 2f64.sqrt());
        assert!(points(&window) < 12, "{}", points(&window));
        assert!(off_circle(&window) < 0.005);
        assert_eq!(
            value(&window, language.parameter("points")),
            points(&window).to_string()
        );
        click_button(&mut window, |texts| texts.tools.ok);
        assert!(window.state().windows.tool.is_none());
    }
}

/// Points entered change the tolerance that is shown, and a tolerance entered the points.
#[test]
fn points_and_tolerance_follow_one_another() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = recorded(folder.path(), 0.0, &[]);
    let mut window = window(Language::English);
    imported(&mut window, &file);
    let tolerance = value(&window, "Tolerance");
    let fewer = points(&window) - 1;
    enter(&mut window, "Points", &fewer.to_string());
    assert!(points(&window) <= fewer);
    let few = value(&window, "Tolerance");
    assert_ne!(few, tolerance);
    let of = |text: &str| text.parse::<f64>().expect("a number");
    assert!(report(&window).position.greatest <= 1.01 * of(&few));
    enter(&mut window, "Tolerance", "0.0001");
    assert!(points(&window) > fewer);
    assert!(report(&window).position.greatest <= 1.01e-4);
    assert_eq!(value(&window, "Points"), points(&window).to_string());
    // Fewer than a path has is refused in words, and the next number is taken.
    enter(&mut window, "Points", "1");
    let tool = window.state().windows.tool.as_ref().expect("a window");
    assert!(tool.trouble.is_some() && tool.fit.is_none());
    enter(&mut window, "Points", "4");
    assert!((2..=4).contains(&points(&window)));
}

#[test]
fn a_tolerance_below_the_noise_offers_a_better_one() {
    for (language, theme, scale, name) in LOOKS {
        let folder = tempfile::tempdir().expect("a folder");
        let file = recorded(folder.path(), 0.01, &[]);
        let mut window = window_with_points(language, SMALL, scale, theme);
        imported(&mut window, &file);
        click(&mut window, language.choice("replace"));
        enter(&mut window, language.parameter("tolerance"), "0.005");
        let before = report(&window);
        let (tolerance, points_then) = before.better.expect("a better tolerance");
        screenshot(&mut window, &format!("fit-better-{name}.png"));
        let offer = fill(
            language.texts().fit.better,
            &[&super::of_tolerance(language, tolerance), &points_then],
        );
        click(&mut window, &offer);
        assert_eq!(points(&window), points_then);
        assert!(2 * points_then <= before.points && report(&window).better.is_none());
        assert!(report(&window).position.greatest <= 1.001 * tolerance.position);
    }
}

#[test]
fn outliers_that_cost_points_are_offered_to_be_left_out() {
    for language in BOTH {
        let folder = tempfile::tempdir().expect("a folder");
        let outliers = [31, 77, 120, 121, 180, 207];
        let file = recorded(folder.path(), 0.0, &outliers);
        let mut window = window(language);
        imported(&mut window, &file);
        let (left_out, points_then) = report(&window).robust.expect("an offer");
        assert_eq!(left_out, outliers.len());
        let offer = fill(language.texts().fit.robust, &[&points_then]);
        click(&mut window, &offer);
        assert_eq!(points(&window), points_then);
        let tool = window.state().windows.tool.as_ref().expect("a window");
        let (_, out) = tool.recorded().expect("poses");
        assert_eq!(out, outliers);
        assert!(off_circle(&window) < 0.005);
        assert!(window.query_by_label(&offer).is_none());
        screenshot(&mut window, &format!("fit-robust-{language:?}.png"));
    }
}

/// The picture of the deviation leads to the frame that is clicked.
#[test]
fn a_click_into_the_deviation_moves_the_playhead() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = recorded(folder.path(), 0.0, &[]);
    let mut window = window(Language::English);
    imported(&mut window, &file);
    let name = Language::English.texts().fit.position_graph;
    let middle = window.get_by_label(name).rect().center();
    window.hover_at(middle);
    window.run();
    window.drag_at(middle);
    window.run();
    window.drop_at(middle);
    window.run();
    let frame = window.state().previewed_frame().expect("a frame");
    // 239 steps of 1/30 s at 25 frames a second.
    assert!(
        (frame - (1.0 + 0.5 * 239.0 / 30.0 * 25.0)).abs() <= 2.0,
        "{frame}"
    );
}

/// Recorded poses come after the film that is there; its poses stay, and graphs count from them.
#[test]
fn recorded_poses_come_after_the_film() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = recorded(folder.path(), 0.0, &[]);
    let mut window = window(Language::English);
    imported(&mut window, &file);
    let alone = window.state().document.path().clone();
    let film = some_points();
    let mut window = window_of(
        Options {
            document: some_points(),
            ..options(Language::English)
        },
        LARGE,
        1.0,
        Theme::Dark,
    );
    imported(&mut window, &file);
    let places = |path: &vides_engine::path::CameraPath| {
        let all = path.points.iter().map(|point| point.position);
        all.collect::<Vec<_>>()
    };
    let both = [places(film.path()), places(&alone)].concat();
    assert_eq!(places(window.state().document.path()), both);
    let frames = |document: &Document| document.sampler().expect("poses").frame_count() as f64;
    let tool = window.state().windows.tool.as_ref().expect("a window");
    let shown = tool.fit.as_ref().expect("a fit");
    let [first, last] = [&shown.places[0], &shown.places[shown.places.len() - 1]];
    assert!(first.frame > frames(&film), "{first:?} {}", frames(&film));
    let all = frames(&window.state().document);
    assert!((last.frame - all).abs() < 1.0, "{last:?} of {all}");
    click(&mut window, Language::English.choice("replace"));
    assert_eq!(places(window.state().document.path()), places(&alone));
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().document.path(), film.path());
}
