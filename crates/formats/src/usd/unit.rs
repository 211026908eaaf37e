//! Names of units of length, and `metersPerUnit`.

/// Names, the usual one first, and metres.
const UNITS: &[(&[&str], f64)] = &[
    (&["m", "metre", "meter", "metres", "meters"], 1.0),
    (&["cm", "centimetre", "centimeter"], 0.01),
    (&["mm", "millimetre", "millimeter"], 0.001),
    (&["km", "kilometre", "kilometer"], 1000.0),
    (&["dm", "decimetre", "decimeter"], 0.1),
    (&["µm", "um", "μm", "micrometre", "micrometer"], 1e-6),
    (&["nm", "nanometre", "nanometer"], 1e-9),
    (&["in", "inch", "inches", "\""], 0.0254),
    (&["ft", "foot", "feet", "'"], 0.3048),
    (&["yd", "yard", "yards"], 0.9144),
    (&["mi", "mile", "miles"], 1609.344),
];

/// The metres of a unit, if it is known.
pub(super) fn metres(name: &str) -> Option<f64> {
    let name = name.trim().to_lowercase();
    let mut units = UNITS.iter();
    let known = units.find(|(names, _)| names.contains(&name.as_str()));
    known.map(|(_, metres)| *metres)
}

/// The usual name of a unit of this length, otherwise the metres.
pub(super) fn name(metres: f64) -> String {
    let near = |known: &f64| (metres / known - 1.0).abs() < 1e-6;
    match UNITS.iter().find(|(_, known)| near(known)) {
        Some((names, _)) => names[0].to_owned(),
        None => format!("{metres} m"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back() {
        for (names, value) in UNITS {
            assert_eq!(name(*value), names[0]);
            assert!(names.iter().all(|name| metres(name) == Some(*value)));
        }
        assert_eq!((metres(" CM "), metres("parsec")), (Some(0.01), None));
        assert_eq!(name(0.010000000707805157), "cm");
        assert_eq!(name(2.5), "2.5 m");
    }
}
