//! A text, a number, a switch or a date from what stands in a file.

use std::borrow::Cow;

use toml::de::DeValue;
use toml_parser::decoder::ScalarKind;
use toml_parser::{ParseError, Raw};

use super::tree::Value;

/// None: it is no TOML.
pub(super) fn value(raw: Raw<'_>) -> Option<Value<'_>> {
    let (mut text, mut wrong) = (Cow::Borrowed(""), None::<ParseError>);
    let scalar = raw.decode_scalar(&mut text, &mut wrong);
    // Whether there is such a day and hour only the crate `toml` knows.
    let date = || DeValue::parse(raw.as_str()).is_ok();
    if wrong.is_some() || scalar == ScalarKind::DateTime && !date() {
        return None;
    }
    let number = |text: &str| text.parse().unwrap_or(f64::NAN);
    Some(match scalar {
        ScalarKind::String => Value::Text(text),
        ScalarKind::Boolean(boolean) => Value::Boolean(boolean),
        ScalarKind::DateTime => Value::Date,
        ScalarKind::Float => Value::Float(number(&text)),
        ScalarKind::Integer(radix) => {
            let whole = i64::from_str_radix(&text, radix.value()).ok();
            let number = match radix.value() {
                10 => number(&text),
                _ => whole.map_or(f64::NAN, |whole| whole as f64),
            };
            Value::Integer(number, whole)
        }
    })
}
