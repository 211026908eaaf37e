//! A web page that plays the flight in any browser, without a network and without other files.
//!
//! Its parts are readable files beside this one: `page.html`, `page.css` and the scripts, which
//! know nothing of Rust. Here they are put together with the flight as data ([`data`]): JSON in
//! which no `<` stands, so that no text of the document ends its element. The page's policy allows
//! nothing but the one style and the one script, by their digests.

mod data;
mod sha256;

use std::io::Write;

use sha256::sha256;

use super::base64::base64;
use super::blocks::failed;
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::Report;

pub(super) static HTML: Format = Format {
    name: "html",
    title: "Web page",
    endings: &["html", "htm"],
    holds: Holds::View,
    write: Some(write),
    ..Format::PLAIN
};

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = concat!(
    "(() => {\n\"use strict\";\n",
    include_str!("flight.js"),
    include_str!("texts.js"),
    include_str!("draw.js"),
    include_str!("things.js"),
    include_str!("names.js"),
    include_str!("space.js"),
    include_str!("graph.js"),
    include_str!("page.js"),
    "})();\n"
);

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let (head, tail) = PAGE.split_once("@DATA@").unwrap_or((PAGE, ""));
    let head = head
        .replace("@POLICY@", &policy())
        .replace("@STYLE@", STYLE)
        .replace("@SCRIPT@", SCRIPT);
    out.write_all(head.as_bytes()).map_err(failed)?;
    data::write(flight, out, report)?;
    out.write_all(tail.as_bytes()).map_err(failed)
}

/// What the page may load and run: itself.
fn policy() -> String {
    let digest = |text: &str| {
        let digits = base64(&sha256(text.as_bytes()));
        format!("'sha256-{}'", String::from_utf8_lossy(&digits))
    };
    format!(
        "default-src 'none'; script-src {}; style-src {}; img-src data:; base-uri 'none'; \
         form-action 'none'",
        digest(SCRIPT),
        digest(STYLE)
    )
}

#[cfg(test)]
mod tests;
