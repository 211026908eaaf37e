//! How the help groups the subcommands, and one example of each.

use clap::{Command, CommandFactory};

use super::Cli;

/// A heading, and subcommands with an example each.
type Group = (&'static str, &'static [(&'static str, &'static str)]);

#[rustfmt::skip]
pub(super) const GROUPS: [Group; 5] = [
    ("Make a path", &[
        ("edit", "vides edit mesh.glb"),
        ("tour", "vides tour mesh.obj --seconds 30 -o tour.vid"),
        ("orbit", "vides orbit --object mesh.obj --turns 2 --seconds 12 -o orbit.vid"),
        ("spiral", "vides spiral --radius 2 --end-radius 1 --end-height 2 -o spiral.vid"),
        ("arc", "vides arc --radius 2 --from -30 --to 30 -o arc.vid"),
        ("flyby", "vides flyby --distance 1.5 --length 4 -o flyby.vid"),
        ("approach", "vides approach --distance 3 --end-distance 1 -o approach.vid"),
        ("dolly-zoom", "vides dolly-zoom --zoom 24 --seconds 6 -o dolly.vid"),
        ("crane", "vides crane --height 0 --end-height 2 -o crane.vid"),
        ("pan", "vides pan --at 0,1,0 --from -45 --to 45 -o pan.vid"),
        ("figure-eight", "vides figure-eight --width 2 -o eight.vid"),
        ("fit", "vides fit poses.csv --tolerance 0.01 --angle 0.5 -o path.vid"),
    ]),
    ("Change a path", &[
        ("set", "vides set flight.vid point.2.zoom=35 fps=30"),
        ("move", "vides move flight.vid --by 0,1,0 --first 2 --last 3 -o moved.vid"),
        ("turn", "vides turn flight.vid --axis y --angle 30 --about 0,0,0 -o turned.vid"),
        ("scale", "vides scale flight.vid --factor 0.5 --with-targets -o half.vid"),
        ("mirror", "vides mirror flight.vid --axis x --about origin -o mirrored.vid"),
        ("taper", "vides taper flight.vid --r0 1 --r1 0.5 -o taper.vid"),
        ("bulge", "vides bulge flight.vid --a 2 -o bulge.vid"),
        ("twist", "vides twist flight.vid --axis y --angle 90 -o twist.vid"),
        ("bend", "vides bend flight.vid --axis x --angle 45 -o bend.vid"),
        ("free-form", "vides free-form flight.vid --box -1,-1,-1,1,1,1 -o same.vid"),
        ("extract", "vides extract flight.vid --first 2 --last 3 -o part.vid"),
        ("insert", "vides insert flight.vid part.vid --at 3 --fit turn -o longer.vid"),
        ("blend", "vides blend flight.vid other.vid --weight 0.5 -o between.vid"),
        ("reverse", "vides reverse flight.vid -o back.vid"),
        ("repeat", "vides repeat flight.vid --times 3 -o thrice.vid"),
        ("steady", "vides steady recorded.vid --period 1 --within 0.05 -o steady.vid"),
        ("avoid", "vides avoid flight.vid --object mesh.obj --clearance 0.1 -o clear.vid"),
        ("picture", "vides picture flight.vid --object mesh.obj --what view -o framed.vid"),
    ]),
    ("Time", &[
        ("frames", "vides frames flight.vid --seconds 10 -o timed.vid"),
        ("retime", "vides retime flight.vid --limit speed=0.5 --seconds 20 -o timed.vid"),
    ]),
    ("Look and check", &[
        ("info", "vides info flight.vid"),
        ("get", "vides get flight.vid fps point.2.zoom"),
        ("check", "vides check flight.vid --fix -o fixed.vid"),
        ("plot", "vides plot flight.vid -o flight.svg"),
    ]),
    ("Convert", &[
        ("sample", "vides sample flight.vid --format csv -o flight.csv"),
        ("convert", "vides convert flight.vid flight.glb"),
    ]),
];

/// The command with its help by groups.
pub(super) fn command() -> Command {
    let mut command = Cli::command();
    let mut text = String::new();
    for (heading, rows) in GROUPS {
        text += &format!("{heading}:\n");
        for &(name, example) in rows {
            command = command.mut_subcommand(name, |subcommand| {
                let about = subcommand.get_about().map(ToString::to_string);
                text += &format!("  {name:<12}  {}\n", about.unwrap_or_default());
                let more = subcommand.get_after_help().map(ToString::to_string);
                let more = more.map_or(String::new(), |more| format!("{more}\n"));
                subcommand.after_help(format!("{more}Example: {example}"))
            });
        }
        text.push('\n');
    }
    command.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{text}Options:\n{{options}}{{after-help}}"
    ))
}
