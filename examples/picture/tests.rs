//! The picture read back: is it XML, is everything in it, and in its place?

use std::path::Path;

use glam::dvec3;
use roxmltree::{Document as Xml, Node};
use vides::document::{Document, Info};
use vides::path::{CameraPath, SupportPoint};

use super::{HEIGHT, WIDTH, picture};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn pyramid() -> Document {
    Document::load(&Path::new(ROOT).join("examples/pyramid.vid")).unwrap()
}

fn group<'a>(xml: &'a Xml<'_>, id: &str) -> Node<'a, 'a> {
    let found = xml
        .descendants()
        .find(|node| node.attribute("id") == Some(id));
    found.unwrap_or_else(|| panic!("no group {id}"))
}

/// Every number in a text, in order.
fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
        .filter_map(|word| word.parse().ok())
        .collect()
}

/// Whatever is said about the shape of an element.
const PLACES: [&str; 12] = [
    "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "width", "height", "points", "d",
];

fn places(node: Node<'_, '_>) -> Vec<f64> {
    let given = PLACES.iter().filter_map(|name| node.attribute(*name));
    given.flat_map(numbers).collect()
}

#[test]
fn the_pyramid_has_all_its_parts() {
    let text = picture(&pyramid()).unwrap();
    let xml = Xml::parse(&text).unwrap();
    assert!(
        xml.root_element()
            .has_tag_name(("http://www.w3.org/2000/svg", "svg"))
    );

    let cube = group(&xml, "cube");
    assert_eq!(cube.children().filter(Node::is_element).count(), 12);
    let dashed = |node: &Node<'_, '_>| node.attribute("stroke-dasharray").is_some();
    assert_eq!(cube.children().filter(dashed).count(), 3);
    // Ten points; lines lead to all but the first of either polyline.
    let object = group(&xml, "object");
    assert_eq!(object.children().filter(Node::is_element).count(), 8);
    // Two strokes for a cross; each label once as its own rim.
    let points = group(&xml, "points");
    let lines = points
        .children()
        .filter(|node| node.attribute("x1").is_some());
    assert_eq!(lines.count(), 2 * 6);
    assert_eq!(
        points
            .descendants()
            .filter(|node| node.text() == Some("4 right corner"))
            .count(),
        4
    );

    let path = group(&xml, "curve").first_element_child().unwrap();
    assert_eq!(path.attribute("d").unwrap().matches('C').count(), 5);
    // Eight sections, two rests.
    let sections = group(&xml, "sections");
    let bands = sections
        .children()
        .filter(|node| node.attribute("fill").is_some() && node.attribute("width").is_some());
    assert_eq!(bands.count(), 3 * 10);
    for chart in ["speed", "turning"] {
        let line = group(&xml, chart)
            .children()
            .find_map(|node| node.attribute("points"))
            .unwrap();
        let frames = pyramid().sampler().unwrap().frame_count();
        assert_eq!(numbers(line).len(), 2 * (frames - 1));
    }
    // Two for a camera: its picture and its roof. There are nine keys, and some
    // cameras between them.
    let polygons = group(&xml, "cameras")
        .children()
        .filter(|node| node.has_tag_name("polygon"));
    assert!(polygons.clone().count() > 2 * 9);
    let keys = polygons.filter(|node| node.attribute("fill-opacity") == Some("0.16"));
    assert_eq!(keys.count(), 9);
}

#[test]
fn the_curve_goes_through_the_crosses() {
    let text = picture(&pyramid()).unwrap();
    let xml = Xml::parse(&text).unwrap();
    let strokes: Vec<Vec<f64>> = group(&xml, "points")
        .children()
        .filter(|node| node.attribute("x1").is_some())
        .map(places)
        .collect();
    let crosses: Vec<_> = strokes
        .iter()
        .step_by(2)
        .map(|s| ((s[0] + s[2]) / 2.0, (s[1] + s[3]) / 2.0))
        .collect();
    let path = group(&xml, "curve").first_element_child().unwrap();
    let curve = numbers(path.attribute("d").unwrap());
    assert_eq!(curve.len(), 5 * 8);
    for (segment, ends) in curve.chunks(8).zip(crosses.windows(2)) {
        for (x, y, cross) in [
            (segment[0], segment[1], ends[0]),
            (segment[6], segment[7], ends[1]),
        ] {
            assert!((x - cross.0).abs() < 0.02 && (y - cross.1).abs() < 0.02);
        }
    }
}

/// Left, top, right and bottom of a text, by a letter's usual width.
fn extent(node: Node<'_, '_>) -> [f64; 4] {
    let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let size = node
        .attribute("font-size")
        .map_or(12.5, |size| size.parse().unwrap());
    let width = 0.5 * size * node.text().unwrap().chars().count() as f64;
    let (x, y) = (number("x"), number("y"));
    let left = match node.attribute("text-anchor") {
        Some("middle") => x - width / 2.0,
        Some("end") => x - width,
        _ => x,
    };
    [left, y - 0.72 * size, left + width, y + 0.2 * size]
}

#[test]
fn nothing_lies_outside_and_no_text_on_another() {
    let text = picture(&pyramid()).unwrap();
    let xml = Xml::parse(&text).unwrap();
    for node in xml
        .descendants()
        .filter(|node| node.attribute("points").is_some())
    {
        for spot in places(node).chunks(2) {
            assert!((0.0..=WIDTH).contains(&spot[0]) && (0.0..=HEIGHT).contains(&spot[1]));
        }
    }
    let is_text = |node: &Node<'_, '_>| node.has_tag_name(("http://www.w3.org/2000/svg", "text"));
    let is_rim = |node: &Node<'_, '_>| node.attribute("stroke").is_some();
    let texts: Vec<_> = xml
        .descendants()
        .filter(|node| is_text(node) && !is_rim(node) && node.text().is_some())
        .map(|node| (node.text().unwrap(), extent(node)))
        .collect();
    assert!(texts.len() > 50);
    for (index, (text, [left, top, right, bottom])) in texts.iter().enumerate() {
        let inside = *left >= 0.0 && *right <= WIDTH && *top >= 0.0 && *bottom <= HEIGHT;
        assert!(inside, "{text}");
        for (other, [l, t, r, b]) in &texts[..index] {
            let apart = right < l || r < left || bottom < t || b < top;
            assert!(apart, "{text} lies on {other}");
        }
    }
}

/// `docs/pyramid.svg` is what the program draws today, to the last decimals,
/// which may differ from processor to processor.
#[test]
fn the_picture_in_the_documentation_is_current() {
    let drawn = picture(&pyramid()).unwrap();
    let kept = std::fs::read_to_string(Path::new(ROOT).join("docs/pyramid.svg")).unwrap();
    let (drawn, kept) = (Xml::parse(&drawn).unwrap(), Xml::parse(&kept).unwrap());
    assert_eq!(drawn.descendants().count(), kept.descendants().count());
    for (a, b) in drawn.descendants().zip(kept.descendants()) {
        assert_eq!(a.tag_name(), b.tag_name());
        assert_eq!(a.text(), b.text());
        let (a, b) = (places(a), places(b));
        assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            assert!(
                (a - b).abs() < 0.05,
                "{a} was {b}; anew: cargo run -p vides-picture -- examples/pyramid.vid docs/pyramid.svg"
            );
        }
    }
}

#[test]
fn every_path_has_a_picture() {
    let check = |document: Document| {
        let text = picture(&document).unwrap();
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        let xml = Xml::parse(&text).unwrap();
        group(&xml, "legend");
    };
    check(Document::new());
    let parts = |positions: &[[f64; 3]], change: &dyn Fn(&mut CameraPath)| {
        let mut path = CameraPath {
            points: positions
                .iter()
                .map(|p| SupportPoint::new(dvec3(p[0], p[1], p[2])))
                .collect(),
            ..CameraPath::default()
        };
        change(&mut path);
        let info = Info {
            title: "<a> & \"b\" \u{fffe}".to_owned(),
            ..Info::default()
        };
        Document::from_parts(path, info).unwrap()
    };
    // One frame; two; far away and large; closed with rests and odd names.
    check(parts(&[[0.0; 3]; 2], &|_| {}));
    check(parts(&[[0.0; 3], [1e-3, 0.0, 0.0]], &|_| {}));
    check(parts(&[[1e9, -1e9, 0.0], [-1e9, 1e9, 1e9]], &|path| {
        path.speeds.movement = 1e-7;
    }));
    check(parts(
        &[[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]],
        &|path| {
            path.closed = true;
            for point in &mut path.points {
                point.name =
                    Some("<&> a name that is far too long to stand beside a point".to_owned());
                point.orientations[0].hold = 7;
            }
        },
    ));
    let many: Vec<[f64; 3]> = (0..200)
        .map(|i| [f64::from(i % 7), f64::from(i % 3), 0.1])
        .collect();
    check(parts(&many, &|_| {}));
}
