//! The options of a tool: its table makes them, and they give its numbers.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgMatches};
use vides::document::Document;
use vides::document::tool::Tool;
use vides::tools::{Parameter, Unit};

use super::failure::Failure;

/// Numbers separated by commas.
pub(super) fn numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',')
        .map(|number| match number.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(format!("\"{number}\" is not a number")),
        })
        .collect()
}

/// As many numbers as `WIDTH`.
pub(super) fn exactly<const WIDTH: usize>(text: &str) -> Result<[f64; WIDTH], String> {
    let numbers = numbers(text)?;
    <[f64; WIDTH]>::try_from(numbers)
        .map_err(|_| format!("{WIDTH} numbers with commas between are needed"))
}

/// The option of a parameter, with unit, range and default.
pub(super) fn option(parameter: &'static Parameter) -> Arg {
    let Parameter { name, width, .. } = *parameter;
    let arg = Arg::new(name).long(name).help(help(parameter));
    match parameter.unit {
        Unit::Choice(names) if name == "about" => arg
            .value_name("PLACE")
            .value_parser(move |text: &str| match index(names, text) {
                Some(at) => Ok(vec![at]),
                None => exactly::<3>(text).map(Vec::from),
            })
            .allow_hyphen_values(true),
        Unit::Choice(names) => arg.value_name("NAME").value_parser(
            PossibleValuesParser::new(names)
                .map(move |name| index(names, &name).into_iter().collect::<Vec<_>>()),
        ),
        Unit::Switch => arg
            .value_name("yes|no")
            .num_args(0..=1)
            .require_equals(true)
            .default_missing_value("yes")
            .hide_possible_values(true)
            .value_parser(
                PossibleValuesParser::new(["no", "yes"])
                    .map(|name| index(&["no", "yes"], &name).into_iter().collect::<Vec<_>>()),
            ),
        unit => arg
            .value_name(match unit {
                _ if width == 3 => "X,Y,Z",
                Unit::Lattice => "NUMBERS",
                Unit::Length => "LENGTH",
                Unit::Degrees => "DEGREES",
                Unit::Zoom => "MM",
                Unit::Seconds => "SECONDS",
                _ => "NUMBER",
            })
            .value_parser(move |text: &str| {
                let numbers = numbers(text)?;
                match numbers.len() == width {
                    true => Ok(numbers),
                    false => Err(format!("{width} numbers with commas between are needed")),
                }
            })
            .allow_negative_numbers(true)
            .allow_hyphen_values(true),
    }
}

fn index(names: &[&str], wanted: &str) -> Option<f64> {
    let at = names.iter().position(|name| *name == wanted);
    at.map(|at| at as f64)
}

/// Text with a capital letter at its beginning.
pub(super) fn sentence(text: &str) -> String {
    let mut text = text.to_owned();
    text[..1].make_ascii_uppercase();
    text
}

fn help(parameter: &Parameter) -> String {
    let Parameter {
        least,
        most,
        default,
        ..
    } = *parameter;
    let does = sentence(parameter.does);
    match parameter.unit {
        Unit::Choice(names) if parameter.name == "about" => {
            let names = names.join(", ");
            format!("{does}: {names}, or X,Y,Z [default: {}]", &names[..6])
        }
        Unit::Choice(names) => format!("{does} [default: {}]", names[default as usize]),
        Unit::Count if parameter.name == "last" => {
            format!("{does}; {least} to {most} [default: the last of the path]")
        }
        Unit::Switch if default == 0.0 => does,
        Unit::Switch => format!("{does} [default: yes]"),
        Unit::Lattice => format!(
            "{does}: x,y,z of each, {} numbers; -1 to 1 is the box [default: not deformed]",
            parameter.width
        ),
        Unit::Length => {
            let range = match least {
                least if least < 0.0 => "",
                0.0 => "; 0 or more",
                _ => "; greater than 0",
            };
            let default = vec![default.to_string(); parameter.width].join(",");
            format!("{does}{range} [default: {default}]")
        }
        _ => format!("{does}; {least} to {most} [default: {default}]"),
    }
}

/// The numbers that were given to a tool.
pub(super) struct Given(Vec<(&'static Parameter, Vec<f64>)>);

impl Given {
    pub(super) fn of(
        parameters: impl Iterator<Item = &'static Parameter>,
        matches: &ArgMatches,
    ) -> Self {
        let given = parameters.filter_map(|parameter| {
            let numbers = matches.get_one::<Vec<f64>>(parameter.name)?;
            Some((parameter, numbers.clone()))
        });
        Self(given.collect())
    }

    pub(super) fn get(&self, name: &str) -> Option<&[f64]> {
        let found = self.0.iter().find(|(parameter, _)| parameter.name == name);
        found.map(|(_, numbers)| &numbers[..])
    }

    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.get(name).map(|numbers| numbers[0])
    }

    /// Puts them in the place of defaults, where `place` has a parameter's first number.
    pub(super) fn replace(&self, numbers: &mut [f64], place: impl Fn(&str) -> Option<usize>) {
        for (parameter, given) in &self.0 {
            // A fixed point of one's own is no number of the tool.
            if let Some(at) = place(parameter.name).filter(|_| given.len() == parameter.width) {
                numbers[at..at + given.len()].copy_from_slice(given);
            }
        }
    }
}

/// All numbers of a tool for a document, within the ranges of its table.
pub(super) struct Numbers<'a> {
    tool: &'a Tool,
    pub(super) all: Vec<f64>,
}

impl<'a> Numbers<'a> {
    pub(super) fn new(tool: &'a Tool, given: &Given, document: &Document) -> Result<Self, Failure> {
        let mut all = tool.defaults(document)?;
        given.replace(&mut all, |name| tool.place_of(name));
        let half_size = document.path().space.half_size;
        let mut rest = all.iter();
        for parameter in tool.parameters() {
            for number in rest.by_ref().take(parameter.width) {
                let checked = parameter.check(*number, half_size);
                checked.map_err(vides::Error::from)?;
            }
        }
        Ok(Self { tool, all })
    }

    pub(super) fn one(&self, name: &str) -> f64 {
        self.tool.place_of(name).map_or(0.0, |at| self.all[at])
    }

    /// A point, counted from 0.
    pub(super) fn point(&self, name: &str) -> usize {
        self.one(name) as usize - 1
    }
}
