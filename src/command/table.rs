//! Text in columns.

use std::fmt::{self, Display};

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Right,
}

pub(super) struct Table {
    columns: Vec<(&'static str, Align)>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(super) fn new(columns: &[(&'static str, Align)]) -> Self {
        Self {
            columns: columns.to_vec(),
            rows: Vec::new(),
        }
    }

    /// Adds a row with one cell per column.
    pub(super) fn row(&mut self, cells: Vec<String>) {
        debug_assert_eq!(cells.len(), self.columns.len());
        self.rows.push(cells);
    }
}

impl Display for Table {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |text: &str| text.chars().count();
        let widths: Vec<usize> = self
            .columns
            .iter()
            .enumerate()
            .map(|(index, (head, _))| {
                let cells = self.rows.iter().map(|row| width(&row[index]));
                cells.max().unwrap_or(0).max(width(head))
            })
            .collect();
        let mut line = |cells: &mut dyn Iterator<Item = &str>| {
            let mut text = String::new();
            for ((cell, (_, align)), &widest) in cells.zip(&self.columns).zip(&widths) {
                let blanks = " ".repeat(widest - width(cell));
                let (before, after) = match align {
                    Align::Left => ("", blanks.as_str()),
                    Align::Right => (blanks.as_str(), ""),
                };
                text.extend(["  ", before, cell, after]);
            }
            writeln!(out, "{}", text.trim_end())
        };
        line(&mut self.columns.iter().map(|(head, _)| *head))?;
        self.rows
            .iter()
            .try_for_each(|row| line(&mut row.iter().map(String::as_str)))
    }
}

/// Decimals for some numbers: four if the largest is of everyday size, else for its five digits.
pub(super) fn decimals(numbers: impl Iterator<Item = f64>) -> usize {
    let largest = numbers.map(f64::abs).fold(0.0, f64::max);
    if largest == 0.0 || (1e-2..1e5).contains(&largest) {
        return 4;
    }
    (4.0 - largest.log10().floor()).clamp(0.0, 17.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_below_each_other() {
        let mut table = Table::new(&[
            ("No.", Align::Right),
            ("Name", Align::Left),
            ("x", Align::Right),
        ]);
        table.row(vec!["1".into(), "Höhe".into(), "-0.5".into()]);
        table.row(vec!["12345".into(), String::new(), "0.5".into()]);
        let expected = "    No.  Name     x\n      1  Höhe  -0.5\n  12345         0.5\n";
        assert_eq!(table.to_string(), expected);
    }

    #[test]
    fn numbers_of_every_size_can_be_read() {
        let of = |number: f64| decimals([0.0, -number].into_iter());
        assert_eq!([of(0.0), of(0.8), of(2.5), of(99_999.0)], [4; 4]);
        assert_eq!([of(1e5), of(1e9), of(1e-3), of(1e-300)], [0, 0, 7, 17]);
    }
}
