//! Converts values of properties between TOML, as in files, and Python.

use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};

use toml::de::{DeTable, DeValue};

use crate::error::Failure;

/// The maximum nesting depth; no value is deeper.
const DEEPEST: usize = 16;

/// A Python value as in a file; `None` is the default.
pub(crate) fn to_toml(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_none() {
        return Ok(String::new());
    }
    let mut text = String::new();
    write(value, &mut text, 0)?;
    Ok(text)
}

fn write(value: &Bound<'_, PyAny>, out: &mut String, depth: usize) -> PyResult<()> {
    let deep = || Failure::argument("the value is nested too deeply");
    if depth > DEEPEST {
        return Err(deep().into());
    }
    if let Ok(switch) = value.cast::<PyBool>() {
        out.push_str(if switch.is_true() { "true" } else { "false" });
    } else if let Ok(text) = value.cast::<PyString>() {
        quote(text.to_cow()?.as_ref(), out);
    } else if value.is_instance_of::<PyInt>() {
        out.push_str(value.str()?.to_cow()?.as_ref());
    } else if value.is_instance_of::<PyFloat>() {
        let number: f64 = value.extract()?;
        out.push_str(&format!("{number:?}").to_lowercase());
    } else if let Ok(table) = value.cast::<PyDict>() {
        out.push_str("{ ");
        for (at, (key, value)) in table.iter().enumerate() {
            out.push_str(if at == 0 { "" } else { ", " });
            let key = key
                .cast::<PyString>()
                .map_err(|_| PyTypeError::new_err("the keys of a table must be texts"))?;
            quote(key.to_cow()?.as_ref(), out);
            out.push_str(" = ");
            write(&value, out, depth + 1)?;
        }
        out.push_str(" }");
    } else if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        out.push('[');
        for (at, item) in value.try_iter()?.enumerate() {
            out.push_str(if at == 0 { "" } else { ", " });
            write(&item?, out, depth + 1)?;
        }
        out.push(']');
    } else if let Ok(list) = value.call_method0("tolist") {
        // Arrays and numbers of numpy.
        if list.get_type().is(value.get_type()) {
            return Err(deep().into());
        }
        write(&list, out, depth + 1)?;
    } else {
        let kind = value.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "the value must be a number, a text, a list or a dict, not {kind}"
        )));
    }
    Ok(())
}

/// A value of a file, for Python; an empty one is `None`. Lists become tuples, because changes to a
/// copy would be lost silently.
pub(crate) fn from_toml<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    if text.is_empty() {
        return Ok(py.None().into_bound(py));
    }
    let line = format!("value = {text}");
    let table = DeTable::parse(&line).map_err(|error| Failure::argument(error.message()))?;
    match table.get_ref().get("value") {
        Some(value) => python(py, value.get_ref()),
        None => Ok(py.None().into_bound(py)),
    }
}

/// Writes a basic string of TOML.
fn quote(text: &str, out: &mut String) {
    out.push('"');
    for sign in text.chars() {
        match sign {
            '"' | '\\' => out.extend(['\\', sign]),
            sign if sign.is_control() => out.push_str(&format!("\\u{:04X}", u32::from(sign))),
            sign => out.push(sign),
        }
    }
    out.push('"');
}

fn python<'py>(py: Python<'py>, value: &DeValue<'_>) -> PyResult<Bound<'py, PyAny>> {
    match value {
        DeValue::String(text) => text.into_bound_py_any(py),
        DeValue::Integer(number) => {
            let number = i64::from_str_radix(number.as_str(), number.radix());
            number.unwrap_or(i64::MAX).into_bound_py_any(py)
        }
        DeValue::Float(number) => {
            let number: f64 = number.as_str().parse().unwrap_or(f64::NAN);
            number.into_bound_py_any(py)
        }
        DeValue::Boolean(switch) => switch.into_bound_py_any(py),
        DeValue::Datetime(time) => time.to_string().into_bound_py_any(py),
        DeValue::Array(items) => {
            let items = items.iter().map(|item| python(py, item.get_ref()));
            PyTuple::new(py, items.collect::<PyResult<Vec<_>>>()?)?.into_bound_py_any(py)
        }
        DeValue::Table(table) => {
            let dict = PyDict::new(py);
            for (key, value) in table {
                dict.set_item(key.get_ref(), python(py, value.get_ref())?)?;
            }
            dict.into_bound_py_any(py)
        }
    }
}
