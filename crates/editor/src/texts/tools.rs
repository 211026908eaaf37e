//! Texts of the tools and of their tables, by the names in the tables.

use vides_document::tool::Tool;
use vides_engine::tools::Parameter;

use super::{Language, texts};

texts! {
    Tools {
        menu, moves, planning, shape, timing, ok, ok_hint, write, write_hint, cancel, cancel_hint, result, draw_now, only_path,
        block_written,
    }
}

impl Language {
    pub(crate) fn tool(self, name: &'static str) -> &'static str {
        self.word("tool", name, name)
    }

    /// What a tool does.
    pub(crate) fn tool_hint(self, tool: &Tool) -> &'static str {
        self.word("tool_does", tool.name, tool.does)
    }

    pub(crate) fn parameter(self, name: &'static str) -> &'static str {
        self.word("parameter", name, name)
    }

    pub(crate) fn parameter_hint(self, parameter: &Parameter) -> &'static str {
        self.word("parameter_does", parameter.does, parameter.does)
    }

    pub(crate) fn choice(self, name: &'static str) -> &'static str {
        self.word("choice", name, name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vides_document::tool::tools;
    use vides_engine::tools::Unit;

    #[test]
    fn each_word_of_the_tables_stands_in_both_languages() {
        let all: Vec<Tool> = tools().collect();
        let parameters: Vec<&Parameter> = all.iter().flat_map(|tool| tool.parameters()).collect();
        let choices = parameters
            .iter()
            .flat_map(|parameter| match parameter.unit {
                Unit::Choice(names) => names,
                _ => &[],
            });
        let tools: Vec<&str> = all.iter().map(|tool| tool.name).collect();
        let labels: Vec<&str> = parameters.iter().map(|parameter| parameter.name).collect();
        let does: Vec<&str> = parameters.iter().map(|parameter| parameter.does).collect();
        let choices: Vec<&str> = choices.copied().collect();
        for (language, part, names) in [
            (Language::English, "tool", &tools),
            (Language::English, "parameter", &labels),
            (Language::English, "choice", &choices),
            (Language::German, "tool", &tools),
            (Language::German, "tool_does", &tools),
            (Language::German, "parameter", &labels),
            (Language::German, "parameter_does", &does),
            (Language::German, "choice", &choices),
        ] {
            language.has_exactly(part, names);
        }
    }
}
