//! The numbers of a tool, from options as texts.

use vides_engine::tools::{Parameter, Unit};

use super::Tool;
use crate::editing::Document;
use crate::error::{Error, Malformed, Result, Value};
use crate::named::no_property;

impl Tool {
    /// Its numbers for a document: the defaults, replaced by options, a line `name=value` each. Words
    /// of a name are joined by `-` or `_`; a value is a number, several with commas between, one of
    /// the choices, or yes or no. Points count from 1.
    ///
    /// # Errors
    /// `ErrorKind::Range` for an unknown name, `ErrorKind::Argument` for a value; both with the
    /// name. As [`Tool::defaults`].
    pub fn numbers(&self, document: &Document, options: &str) -> Result<Vec<f64>> {
        let mut numbers = self.defaults(document)?;
        let lines = options.lines().map(str::trim);
        for line in lines.filter(|line| !line.is_empty()) {
            let (name, value) = line.split_once('=').unwrap_or((line, ""));
            let (name, value) = (name.trim().replace('_', "-"), value.trim());
            let known = self.parameters().find(|known| known.name == name);
            let none = || no_property(&name, self.parameters().map(|known| known.name));
            let parameter = known.ok_or_else(none)?;
            let refused = |cause| Error::Property {
                name: (&name).into(),
                cause,
            };
            let start = self.place_of(parameter.name).unwrap_or_default();
            let room = &mut numbers[start..start + parameter.width];
            room.copy_from_slice(&read(parameter, value).map_err(refused)?);
        }
        Ok(numbers)
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
