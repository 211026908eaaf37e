//! Every word that the window shows, German and English.

/// The window's language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// The language of the environment: `LC_ALL`, `LC_MESSAGES`, `LANG`, the
    /// first of these that is set and not empty.
    pub(crate) fn of_environment() -> Self {
        let name = ["LC_ALL", "LC_MESSAGES", "LANG"]
            .iter()
            .filter_map(std::env::var_os)
            .find(|value| !value.is_empty());
        match name {
            Some(name) if name.as_encoded_bytes().starts_with(b"de") => Self::German,
            _ => Self::English,
        }
    }

    pub(super) const fn texts(self) -> &'static Texts {
        match self {
            Self::English => &ENGLISH,
            Self::German => &GERMAN,
        }
    }
}

/// All texts in one language.
pub(super) struct Texts {
    /// Heading of the first panel.
    pub(super) position_and_curve: &'static str,
    handed_over: &'static str,
}

impl Texts {
    /// So many poses went to the host.
    pub(super) fn handed_over(&self, count: usize) -> String {
        self.handed_over.replace("{}", &count.to_string())
    }
}

static ENGLISH: Texts = Texts {
    position_and_curve: "Position and curve",
    handed_over: "{} poses handed over",
};

static GERMAN: Texts = Texts {
    position_and_curve: "Position und Kurve",
    handed_over: "{} Kameraeinstellungen übergeben",
};
