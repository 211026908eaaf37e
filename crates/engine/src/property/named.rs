//! Enumerations whose values have names.

/// Declares an enumeration with the names of its values in files.
#[macro_export]
#[doc(hidden)]
macro_rules! named {
    (
        $(#[$about:meta])*
        $seen:vis enum $type:ident {
            $($(#[$does:meta])* $value:ident = $name:literal,)*
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        $seen enum $type {
            $($(#[$does])* $value,)*
        }

        impl $type {
            /// All of them.
            $seen const ALL: [Self; [$($name),*].len()] = [$(Self::$value),*];
            /// Their names in files.
            $seen const NAMES: &'static [&'static str] = &[$($name),*];

            /// Its name in files.
            #[must_use]
            $seen const fn name(self) -> &'static str {
                match self {
                    $(Self::$value => $name,)*
                }
            }

            /// The same for C.
            #[allow(dead_code)]
            #[must_use]
            $seen const fn c_name(self) -> &'static std::ffi::CStr {
                match self {
                    $(Self::$value => {
                        match std::ffi::CStr::from_bytes_with_nul(concat!($name, "\0").as_bytes()) {
                            Ok(name) => name,
                            Err(_) => c"",
                        }
                    })*
                }
            }

            /// The one of this name.
            #[must_use]
            $seen fn named(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|one| one.name() == name)
            }
        }
    };
}

pub use named;
