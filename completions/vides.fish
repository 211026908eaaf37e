# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_vides_global_optspecs
    string join \n trust h/help V/version
end

function __fish_vides_needs_command
    # Figure out if the current invocation already has a command.
    set -l cmd (commandline -opc)
    set -e cmd[1]
    argparse -s (__fish_vides_global_optspecs) -- $cmd 2>/dev/null
    or return
    if set -q argv[1]
        # Also print the command, so this can be used to figure out what it is.
        echo $argv[1]
        return 1
    end
    return 0
end

function __fish_vides_using_subcommand
    set -l cmd (__fish_vides_needs_command)
    test -z "$cmd"
    and return 1
    contains -- $cmd[1] $argv
end

complete -c vides -n "__fish_vides_needs_command" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_needs_command" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_needs_command" -s V -l version -d 'Print version'
complete -c vides -n "__fish_vides_needs_command" -f -a "edit" -d 'Opens the editor window'
complete -c vides -n "__fish_vides_needs_command" -f -a "sample" -d 'Writes every camera pose of a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "info" -d 'Shows the points, sections, lengths, frames and seconds of a path, or the nodes of a scene'
complete -c vides -n "__fish_vides_needs_command" -f -a "get" -d 'Prints properties of a path by name'
complete -c vides -n "__fish_vides_needs_command" -f -a "set" -d 'Sets properties of a path by name'
complete -c vides -n "__fish_vides_needs_command" -f -a "fit" -d 'Fits a path with few points to recorded poses'
complete -c vides -n "__fish_vides_needs_command" -f -a "check" -d 'Finds what will look wrong: jerks, flips, collisions'
complete -c vides -n "__fish_vides_needs_command" -f -a "plot" -d 'Draws a path, its views, and charts over its frames'
complete -c vides -n "__fish_vides_needs_command" -f -a "retime" -d 'Sets the speed along a path within limits'
complete -c vides -n "__fish_vides_needs_command" -f -a "steady" -d 'Stabilises a recorded flight'
complete -c vides -n "__fish_vides_needs_command" -f -a "avoid" -d 'Moves a path away from an object'
complete -c vides -n "__fish_vides_needs_command" -f -a "picture" -d 'Keeps an object in the picture, as large as a margin allows'
complete -c vides -n "__fish_vides_needs_command" -f -a "tour" -d 'Plans a flight around an object'
complete -c vides -n "__fish_vides_needs_command" -f -a "move" -d 'Makes a path from a standard camera move'
complete -c vides -n "__fish_vides_needs_command" -f -a "transform" -d 'Moves, turns, scales or mirrors points of a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "deform" -d 'Tapers, twists, bends or free-form deforms points of a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "extract" -d 'Extracts a range of points as a new path'
complete -c vides -n "__fish_vides_needs_command" -f -a "insert" -d 'Inserts a path into another'
complete -c vides -n "__fish_vides_needs_command" -f -a "reverse" -d 'Reverses a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "repeat" -d 'Repeats a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "frames" -d 'Sets the number of frames of a path, or of part of it'
complete -c vides -n "__fish_vides_needs_command" -f -a "blend" -d 'Blends paths by weights that sum to 1'
complete -c vides -n "__fish_vides_needs_command" -f -a "convert" -d 'Converts a path or scene to or from the format of another program'
complete -c vides -n "__fish_vides_using_subcommand edit" -l object -d 'A mesh or point cloud (.obj, .ply, .stl, .gltf, .glb) to show as the object; a new path gets a space that fits it' -r -F
complete -c vides -n "__fish_vides_using_subcommand edit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand edit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand sample" -s o -l output -d 'The output file; - is standard output. An existing file is replaced only when everything is written' -r -F
complete -c vides -n "__fish_vides_using_subcommand sample" -l format -d 'The output format' -r -f -a "ascii\t'Ten numbers per line, four decimals: VRP, VPN, VUP (x y z each) and zoom'
csv\t'A header, then frame number, ten numbers and seconds, all digits'
json\t'Title, frames per second and the poses, all digits'"
complete -c vides -n "__fish_vides_using_subcommand sample" -l digits -d 'Decimals of the format ascii, at most 30 [default: 4]' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l node -d 'A node of a scene, at every frame: cameras and lights as poses, others as matrices (16 numbers, column by column)' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l interpolation -d 'A function of the type V_INTERPOLATE for the interpolation "host:NAME" of a scene\'s tracks' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l move-frames -d 'Frames for moving by half the edge of the space, at speed 50' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l turn-frames -d 'Frames for a turn of 180 degrees at speed 50' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l zoom-frames -d 'Frames for a zoom from 1 to 100 mm at speed 50' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l roll-frames -d 'Frames for a roll of 90 degrees at speed 50' -r
complete -c vides -n "__fish_vides_using_subcommand sample" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand sample" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c vides -n "__fish_vides_using_subcommand info" -l json -d 'Prints one JSON object, with all digits'
complete -c vides -n "__fish_vides_using_subcommand info" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand info" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand get" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand get" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand set" -l keep -d 'What stays when the frame rate (fps) changes: the seconds at which things happen, or the frames, so that the film gets faster or slower' -r -f -a "seconds\t''
frames\t''"
complete -c vides -n "__fish_vides_using_subcommand set" -s o -l output -d 'The output file; - is standard output [default: FILE.vid]' -r -F
complete -c vides -n "__fish_vides_using_subcommand set" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand set" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand fit" -l tolerance -d 'Maximum distance of a position from its pose [default: 1/1000 of the diagonal of the bounds of the positions]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l angle -d 'Maximum deviation of view, up and field of view, in degrees [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l points -d 'At most so many points, with the least tolerance that leads to them, in the ratio of --tolerance to --angle' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l fps -d 'Frames per second [default: the file\'s, else its poses per second, else 25]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l object -d 'The object to show with the path: a mesh (.obj, .ply, .stl, .gltf, .glb), or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand fit" -l up -d 'The up axis' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand fit" -l space -d 'The space of the path: its centre and half its size [default: fits the positions, with a margin of a tenth]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand fit" -l robust -d 'Ignores outliers: poses that differ from their neighbours by more than the tolerance; reports how many'
complete -c vides -n "__fish_vides_using_subcommand fit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand fit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand check" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand check" -l limit -d 'Overrides a limit of the file, as in turning=90; turning=off disables that check' -r
complete -c vides -n "__fish_vides_using_subcommand check" -s o -l output -d 'The file that --fix writes' -r -F
complete -c vides -n "__fish_vides_using_subcommand check" -l fix -d 'Applies fixes while they help, writes the path to --output, and reports what was fixed and what remains'
complete -c vides -n "__fish_vides_using_subcommand check" -l json -d 'Prints the findings and notes as a JSON array'
complete -c vides -n "__fish_vides_using_subcommand check" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand check" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand plot" -s o -l output -d 'The output file, .svg or .png; - is standard output, as SVG' -r -F
complete -c vides -n "__fish_vides_using_subcommand plot" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand plot" -l dark -d 'Uses a dark background'
complete -c vides -n "__fish_vides_using_subcommand plot" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand plot" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand retime" -l limit -d 'Overrides a limit of the file, as in turning=90; turning=off removes it. Used here: speed, acceleration, jerk, turning, turning-acceleration, zoom, crossing' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l from -d 'The first point; sections before it are unchanged' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l to -d 'The last point; sections after it are unchanged' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l seconds -d 'Exact duration, with the lowest peaks [default: as short as the limits allow]' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand retime" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand retime" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand steady" -l seconds -d 'Cut-off period: motion of this period is halved, faster motion is removed' -r
complete -c vides -n "__fish_vides_using_subcommand steady" -l within -d 'Maximum distance any position may move' -r
complete -c vides -n "__fish_vides_using_subcommand steady" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand steady" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand steady" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand avoid" -l clearance -d 'Minimum distance from the object, in the path\'s unit' -r
complete -c vides -n "__fish_vides_using_subcommand avoid" -l around -d 'The radius of a sphere around the camera that keeps it' -r
complete -c vides -n "__fish_vides_using_subcommand avoid" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand avoid" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand avoid" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand avoid" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand picture" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand picture" -l node -d 'Only this object of the scene' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l box -d 'A box instead of an object: two opposite corners' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l margin -d 'Free margin on each side, as a share of the picture\'s width and height' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l what -d 'What to change to keep the object in the picture' -r -f -a "zoom\t''
distance\t''
view\t''"
complete -c vides -n "__fish_vides_using_subcommand picture" -l limit -d 'Overrides a limit of the file, as in zoom=10; zoom=off removes it. Used here: zoom; for --what distance, speed and acceleration' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand picture" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand picture" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand tour" -l seconds -d 'Duration of the flight' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l coverage -d 'Share of the visible surface, by area, to show' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l distance -d 'Distance of the camera from what it shows [default: one that has the whole object in the picture]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l start -d 'Where the flight begins [default: a closed round]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l up -d 'The up axis' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand tour" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand tour" -l inside -d 'Flies inside the object, not around it'
complete -c vides -n "__fish_vides_using_subcommand tour" -l stills -d 'Only the views that cover it, one per frame, for photographs; no flight'
complete -c vides -n "__fish_vides_using_subcommand tour" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand tour" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "orbit" -d 'On a circle round a target'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "spiral" -d 'Round a target with another radius and height at the end'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "arc" -d 'On a part of a circle, from one heading to another'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "flyby" -d 'Straight past a target that stays in view'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "approach" -d 'Straight towards a target'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "dolly-zoom" -d 'Towards a target that keeps its size in the picture'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "crane" -d 'Straight up or down beside a target that stays in view'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "pan" -d 'Turns on the spot'
complete -c vides -n "__fish_vides_using_subcommand move; and not __fish_seen_subcommand_from orbit spiral arc flyby approach dolly-zoom crane pan figure-eight" -f -a "figure-eight" -d 'On an eight that lies before the target'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l radius -d 'How far the way is from the axis [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l turns -d 'How often round; negative: clockwise from above [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from orbit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l radius -d 'How far the way is from the axis [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l turns -d 'How often round; negative: clockwise from above [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l end-radius -d 'The radius at the end [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l end-height -d 'The height at the end [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from spiral" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l radius -d 'How far the way is from the axis [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l from -d 'Heading at which the camera begins [default: -45]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l to -d 'Heading at which it ends [default: 45]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from arc" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l distance -d 'How near the way comes, seen from above [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l from -d 'Heading of the camera when it is nearest [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l length -d 'How long the way is [default: 2]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from flyby" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l distance -d 'How far from the target it begins [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l end-distance -d 'How far from the target it ends [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l rise -d 'How steeply the camera is above the target [default: 15]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from approach" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l distance -d 'How far from the target it begins [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l end-distance -d 'How far from the target it ends [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l rise -d 'How steeply the camera is above the target [default: 15]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l zoom -d 'Focal length at the beginning [default: 60]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from dolly-zoom" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l radius -d 'How far the way is from the axis [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l height -d 'How far above the target it begins [default: -0.2]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l end-height -d 'How far above the target it ends [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from crane" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l at -d 'Where the camera stands [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l from -d 'Heading of the first view [default: -45]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l to -d 'Heading of the last view [default: 45]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l tilt -d 'How far it looks up [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from pan" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l radius -d 'How far from the axis it crosses itself [default: 0.7]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l width -d 'How wide it is, twice as wide as deep [default: 1.2]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l from -d 'Heading at which the camera begins [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l zoom -d 'Focal length [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l seconds -d 'How long it takes; 0: by its length [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l fps -d 'Frames in a second [default: 25]' -r
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l up -d 'Which axis is up [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l object -d 'Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -s o -l output -d 'Where the path goes; - is standard output [default: -]' -r -F
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move; and __fish_seen_subcommand_from figure-eight" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand transform" -l points -d 'The points, as in 3 or 2-5 [default: all]' -r
complete -c vides -n "__fish_vides_using_subcommand transform" -l move -d 'Moves by this vector, last' -r
complete -c vides -n "__fish_vides_using_subcommand transform" -l turn -d 'Turns by this many degrees about --axis' -r
complete -c vides -n "__fish_vides_using_subcommand transform" -l axis -d 'The axis of --turn' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand transform" -l scale -d 'Scales by this factor' -r
complete -c vides -n "__fish_vides_using_subcommand transform" -l mirror -d 'Mirrors along this axis' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand transform" -l about -d 'The fixed point [default: the middle of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand transform" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand transform" -l with-targets -d 'Transforms the targets too'
complete -c vides -n "__fish_vides_using_subcommand transform" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand transform" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand deform" -l points -d 'The points, as in 3 or 2-5 [default: all]' -r
complete -c vides -n "__fish_vides_using_subcommand deform" -l box -d 'The box: least x,y,z, then greatest x,y,z [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand deform" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand deform" -l with-targets -d 'Deforms the targets too'
complete -c vides -n "__fish_vides_using_subcommand deform" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand deform" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand extract" -l points -d 'The points, as in 2-5; on a closed path also 5-2' -r
complete -c vides -n "__fish_vides_using_subcommand extract" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand extract" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand extract" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand insert" -l at -d 'The point to insert it after [default: the last]' -r
complete -c vides -n "__fish_vides_using_subcommand insert" -l fit -d 'How it is placed' -r -f -a "none\t'Unchanged'
move\t'Moved to begin at the point'
turn\t'Also turned into the direction of travel'
scale\t'Moved, turned and scaled to end at the next point'"
complete -c vides -n "__fish_vides_using_subcommand insert" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand insert" -l keep-targets -d 'Keeps its absolute targets in place'
complete -c vides -n "__fish_vides_using_subcommand insert" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand insert" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c vides -n "__fish_vides_using_subcommand reverse" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand reverse" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand reverse" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand repeat" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand repeat" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand repeat" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand frames" -l points -d 'The points, as in 2-5 [default: all]' -r
complete -c vides -n "__fish_vides_using_subcommand frames" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand frames" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand frames" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand blend" -l weights -d 'A weight for each path [default: equal weights]' -r
complete -c vides -n "__fish_vides_using_subcommand blend" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand blend" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand blend" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand convert" -l interpolation -d 'A function of the type V_INTERPOLATE for the interpolation "host:NAME" of a scene\'s tracks' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l node -d 'The node of a scene that is written [default: the shown camera]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l clip -d 'The animation of a glTF file that is read [default: all that move different things]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l frames -d 'The frames that are written, first and last, as people count them [default: all]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l fps -d 'Frames per second of what is written, in the same time; of a file that has none when it is read' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l times -d 'frames: a pose for each frame; own: at the keys of the camera, for tum, euroc, osg, kitti and matrices [default: own where a list becomes a list, without --fps and --frames]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l start -d 'The time of the first pose in files of the formats tum, euroc and osg [default: that of a list that becomes a list, else 0]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l size -d 'Width and height of the picture in pixels [default: 1920x1080]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l up -d 'The axis that stands upright in the file [default: as the format says]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l scale -d 'Lengths in the file for one of the path\'s [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l as -d 'What the camera\'s motion becomes: a path of few points (path) or keys (keys) [default: of a list of poses a path; keys stay keys]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l tolerance -d 'How far a fitted path may be from the positions [default: 1/1000 of the diagonal of their bounds]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l angle -d 'How far its view, up and field of view may be from theirs [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l compact -d 'Curves of few keys that stay this near, for formats that have curves [default: a key for each frame]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l digits -d 'Decimals of the format ascii, at most 30 [default: 4]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l rotation-order -d 'The order of the turns in files of the format chan [default: zxy]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l from -d 'The format of IN [default: detected from its content]' -r -f -a "vid\t''
ascii\t''
csv\t''
json\t''
gltf\t''
glb\t''
usda\t''
paraview\t''
nerfstudio\t''
transforms\t''
instant-ngp\t''
cameras\t''
supersplat\t''
tum\t''
euroc\t''
kitti\t''
matrices\t''
open3d\t''
record3d\t''
polycam\t''
colmap\t''
osg\t''
chan\t''"
complete -c vides -n "__fish_vides_using_subcommand convert" -l to -d 'The format of OUT [default: from its name]' -r -f -a "vid\t''
ascii\t''
csv\t''
json\t''
gltf\t''
glb\t''
usda\t''
blender\t''
paraview\t''
vtk\t''
html\t''
nerfstudio\t''
transforms\t''
instant-ngp\t''
cameras\t''
supersplat\t''
tum\t''
euroc\t''
kitti\t''
matrices\t''
open3d\t''
colmap\t''
osg\t''
chan\t''"
complete -c vides -n "__fish_vides_using_subcommand convert" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand convert" -s h -l help -d 'Print help'
