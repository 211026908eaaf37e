//! Texts on how well a path follows recorded poses.

use super::texts;

texts! {
    Fit {
        position, view, lens, position_graph, view_graph, go_there, recording, rate, found, hold,
        holds, gap, gaps, cut, cuts, outlier, outliers, repeated, repeated_times, times_in,
        nanoseconds, microseconds, better, better_hint, robust, robust_hint,
    }
}
