//! The numbers of a tool, from options as texts.

use vides_engine::tools::{Parameter, Unit};

use super::Tool;
use super::arguments::chosen;
use crate::editing::Document;
use crate::error::{Error, Malformed, Result, Value};
use crate::named::no_property;

/// What options as texts give a tool.
#[derive(Debug)]
pub struct ToolOptions {
    tool: Tool,
    /// All its numbers: the defaults, replaced by those that are given.
    pub numbers: Vec<f64>,
    /// Names of what is given.
    given: Vec<&'static str>,
    more: Vec<(&'static str, Vec<f64>)>,
}

impl ToolOptions {
    /// Whether a parameter is given.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.given.contains(&name)
    }

    /// The first number of a parameter; 0 without one.
    #[must_use]
    pub fn number(&self, name: &str) -> f64 {
        let place = self.tool.place_of(name);
        place.map_or(0.0, |at| self.numbers[at])
    }

    /// As [`ToolOptions::number`], of one that is whole and not negative by the table.
    #[must_use]
    pub fn whole(&self, name: &str) -> usize {
        chosen(self.number(name))
    }

    /// The numbers of one of [`Tool::more`], if they are given.
    #[must_use]
    pub fn more(&self, name: &str) -> Option<&[f64]> {
        let mut all = self.more.iter();
        all.find_map(|(known, numbers)| (*known == name).then_some(&**numbers))
    }
}

impl Tool {
    /// Its numbers for a document: the defaults, replaced by options, a line `name=value` each. Words
    /// of a name are joined by `-` or `_`; a value is a number, several with commas between, one of
    /// the choices, or yes or no. Points count from 1.
    ///
    /// # Errors
    /// `ErrorKind::Range` for an unknown name, `ErrorKind::Argument` for a value; both with the
    /// name. As [`Tool::defaults`].
    pub fn options(&self, document: &Document, options: &str) -> Result<ToolOptions> {
        let mut made = ToolOptions {
            tool: *self,
            numbers: self.defaults(document)?,
            given: Vec::new(),
            more: Vec::new(),
        };
        let lines = options.lines().map(str::trim);
        for line in lines.filter(|line| !line.is_empty()) {
            let (name, value) = line.split_once('=').unwrap_or((line, ""));
            let (name, value) = (name.trim().replace('_', "-"), value.trim());
            let all = || self.parameters().chain(self.more());
            let known = all().find(|known| known.name == name);
            let none = || no_property(&name, all().map(|known| known.name));
            let parameter = known.ok_or_else(none)?;
            let refused = |cause| Error::Property {
                name: (&name).into(),
                cause,
            };
            let numbers = read(parameter, value).map_err(refused)?;
            made.given.push(parameter.name);
            match self.place_of(parameter.name) {
                Some(start) => {
                    made.numbers[start..start + parameter.width].copy_from_slice(&numbers);
                }
                None => {
                    let half_size = document.path().space.half_size;
                    let mut each = numbers.iter();
                    each.try_for_each(|number| parameter.check(*number, half_size))?;
                    made.more.retain(|(known, _)| *known != parameter.name);
                    made.more.push((parameter.name, numbers));
                }
            }
        }
        Ok(made)
    }
}

fn read(parameter: &Parameter, value: &str) -> Result<Vec<f64>, Malformed> {
    let expected = |wanted| Malformed::Expected {
        wanted,
        found: Value::Text,
    };
    match (parameter.unit, value) {
        (Unit::Choice(names), _) => {
            let at = names.iter().position(|name| *name == value);
            Ok(vec![at.ok_or(Malformed::OneOf(names))? as f64])
        }
        (Unit::Switch, "yes" | "true" | "1") => Ok(vec![1.0]),
        (Unit::Switch, "no" | "false" | "0") => Ok(vec![0.0]),
        (Unit::Switch, _) => Err(expected(Value::Boolean)),
        _ => {
            let numbers = value.split(',').map(|number| number.trim().parse());
            let numbers: Result<Vec<f64>, _> = numbers.collect();
            let numbers = numbers.map_err(|_| expected(Value::Number))?;
            match numbers.len() == parameter.width {
                true => Ok(numbers),
                false => Err(Malformed::NumberCount {
                    wanted: parameter.width,
                    found: numbers.len(),
                }),
            }
        }
    }
}
