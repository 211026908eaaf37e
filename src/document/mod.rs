//! The path being edited: commands with undo, presets, files.
