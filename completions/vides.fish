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
complete -c vides -n "__fish_vides_needs_command" -f -a "tour" -d 'Makes a flight that shows the object'
complete -c vides -n "__fish_vides_needs_command" -f -a "orbit" -d 'Flies on a circle round a target'
complete -c vides -n "__fish_vides_needs_command" -f -a "spiral" -d 'Flies round a target with another radius and height at the end'
complete -c vides -n "__fish_vides_needs_command" -f -a "arc" -d 'Flies on a part of a circle, from one heading to another'
complete -c vides -n "__fish_vides_needs_command" -f -a "flyby" -d 'Flies straight past a target that stays in view'
complete -c vides -n "__fish_vides_needs_command" -f -a "approach" -d 'Flies straight towards a target'
complete -c vides -n "__fish_vides_needs_command" -f -a "dolly-zoom" -d 'Flies towards a target that keeps its size in the picture'
complete -c vides -n "__fish_vides_needs_command" -f -a "crane" -d 'Flies straight up or down beside a target that stays in view'
complete -c vides -n "__fish_vides_needs_command" -f -a "pan" -d 'Turns on the spot'
complete -c vides -n "__fish_vides_needs_command" -f -a "figure-eight" -d 'Flies on an eight that lies before the target'
complete -c vides -n "__fish_vides_needs_command" -f -a "fit" -d 'Fits a path of few points to recorded poses'
complete -c vides -n "__fish_vides_needs_command" -f -a "set" -d 'Sets properties of a path by name'
complete -c vides -n "__fish_vides_needs_command" -f -a "move" -d 'Moves points'
complete -c vides -n "__fish_vides_needs_command" -f -a "turn" -d 'Rotates points about an axis'
complete -c vides -n "__fish_vides_needs_command" -f -a "scale" -d 'Scales points'
complete -c vides -n "__fish_vides_needs_command" -f -a "mirror" -d 'Mirrors points along an axis'
complete -c vides -n "__fish_vides_needs_command" -f -a "taper" -d 'Makes one end of the points\' box narrower'
complete -c vides -n "__fish_vides_needs_command" -f -a "bulge" -d 'Makes the middle of the points\' box wider'
complete -c vides -n "__fish_vides_needs_command" -f -a "twist" -d 'Twists the points\' box about an axis'
complete -c vides -n "__fish_vides_needs_command" -f -a "bend" -d 'Bends the points\' box along an axis'
complete -c vides -n "__fish_vides_needs_command" -f -a "free-form" -d 'Deforms the points\' box by 4 × 4 × 4 control points'
complete -c vides -n "__fish_vides_needs_command" -f -a "extract" -d 'Writes points as a separate path'
complete -c vides -n "__fish_vides_needs_command" -f -a "insert" -d 'Inserts a path from a file after the current point'
complete -c vides -n "__fish_vides_needs_command" -f -a "blend" -d 'Blends the path with another path from a file'
complete -c vides -n "__fish_vides_needs_command" -f -a "reverse" -d 'Reverses the path'
complete -c vides -n "__fish_vides_needs_command" -f -a "repeat" -d 'Repeats the path'
complete -c vides -n "__fish_vides_needs_command" -f -a "steady" -d 'Stabilises a recorded flight'
complete -c vides -n "__fish_vides_needs_command" -f -a "avoid" -d 'Moves the path away from the object'
complete -c vides -n "__fish_vides_needs_command" -f -a "picture" -d 'Keeps the object in the picture, as large as a margin allows'
complete -c vides -n "__fish_vides_needs_command" -f -a "frames" -d 'Gives points an exact number of frames'
complete -c vides -n "__fish_vides_needs_command" -f -a "retime" -d 'Sets the speed of points within the limits of a check'
complete -c vides -n "__fish_vides_needs_command" -f -a "info" -d 'Shows the sections and frames of a path, or the nodes of a scene'
complete -c vides -n "__fish_vides_needs_command" -f -a "get" -d 'Prints properties of a path by name'
complete -c vides -n "__fish_vides_needs_command" -f -a "check" -d 'Finds what will look wrong: jerks, flips, collisions'
complete -c vides -n "__fish_vides_needs_command" -f -a "plot" -d 'Draws a path, its views, and charts over its frames'
complete -c vides -n "__fish_vides_needs_command" -f -a "sample" -d 'Writes every camera pose of a path'
complete -c vides -n "__fish_vides_needs_command" -f -a "convert" -d 'Converts to or from the format of another program'
complete -c vides -n "__fish_vides_using_subcommand edit" -l object -d 'A mesh or point cloud to show as the object of a path; a new path gets a space around it' -r -F
complete -c vides -n "__fish_vides_using_subcommand edit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand edit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand tour" -l seconds -d 'How long the flight takes; 0.001 to 1000000 [default: 60]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l coverage -d 'The share of the visible surface to show; 0.000001 to 1 [default: 0.95]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l distance -d 'Distance of the camera from what it shows; 0: automatic; 0 or more [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l inside -d 'In the object\'s free space, not around it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand tour" -l start -d 'Where the flight begins [default: a closed round]' -r
complete -c vides -n "__fish_vides_using_subcommand tour" -l up -d 'The up axis' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand tour" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand tour" -l stills -d 'Only the views that cover it, one per frame, for photographs; no flight'
complete -c vides -n "__fish_vides_using_subcommand tour" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand tour" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand orbit" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l radius -d 'Distance from the axis; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l turns -d 'Number of turns; negative: clockwise from above; -1000 to 1000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand orbit" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand orbit" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand orbit" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand orbit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand orbit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand spiral" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l radius -d 'Distance from the axis; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l turns -d 'Number of turns; negative: clockwise from above; -1000 to 1000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l end-radius -d 'The radius at the end; greater than 0 [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l end-height -d 'The height at the end [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand spiral" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand spiral" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand spiral" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand spiral" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand spiral" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand arc" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l radius -d 'Distance from the axis; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: -45]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l to -d 'Heading at which it ends; -360000 to 360000 [default: 45]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand arc" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand arc" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand arc" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand arc" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand arc" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand flyby" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l distance -d 'Least distance, seen from above; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l from -d 'Heading of the camera when it is nearest; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l length -d 'Length of the path; greater than 0 [default: 2]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand flyby" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand flyby" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand flyby" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand flyby" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand flyby" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand approach" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l distance -d 'How far from the target it begins; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l end-distance -d 'How far from the target it ends; greater than 0 [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l rise -d 'How steeply the camera is above the target; -89 to 89 [default: 15]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand approach" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand approach" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand approach" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand approach" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand approach" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l distance -d 'How far from the target it begins; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l end-distance -d 'How far from the target it ends; greater than 0 [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l rise -d 'How steeply the camera is above the target; -89 to 89 [default: 15]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l zoom -d 'Focal length at the beginning; 1 to 2000 [default: 60]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand dolly-zoom" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand crane" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l radius -d 'Distance from the axis; greater than 0 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l height -d 'How far above the target it begins [default: -0.2]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l end-height -d 'How far above the target it ends [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand crane" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand crane" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand crane" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand crane" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand crane" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand pan" -l at -d 'Where the camera stands [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l from -d 'Heading of the first view; -360000 to 360000 [default: -45]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l to -d 'Heading of the last view; -360000 to 360000 [default: 45]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l tilt -d 'How far it looks up; -89 to 89 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand pan" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand pan" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand pan" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand pan" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand pan" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l around -d 'The place in the middle of the view [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l radius -d 'How far from the axis it crosses itself; greater than 0 [default: 0.7]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l height -d 'How far above the target the camera is [default: 0.4]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l width -d 'How wide it is, twice as wide as deep; greater than 0 [default: 1.2]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l from -d 'Heading at which the camera begins; -360000 to 360000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l zoom -d 'Focal length; 1 to 2000 [default: 24]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l seconds -d 'Duration; 0: by its length; 0 to 1000000 [default: 10]' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l fps -d 'Frames per second' -r
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l up -d 'The up axis [default: that of --object, else y]' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l object -d 'Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space around it, or that of a .vid file in its space' -r -F
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand figure-eight" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand fit" -l angle -d 'How far view, up and field of view may be from theirs; 0.000001 to 180 [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l points -d 'Maximum number of points; the tolerance follows from it; 0: as many as the tolerance needs; 0 to 100000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l robust -d 'Ignores outliers: poses that differ from their neighbours' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand fit" -l fps -d 'Frames per second [default: the file\'s, else its poses per second, else 25]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l object -d 'The object to show with the path: a mesh (.obj, .ply, .stl, .gltf, .glb), or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand fit" -l up -d 'The up axis' -r -f -a "y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand fit" -l space -d 'The space of the path: its centre and half its size [default: fits the positions, with a margin of a tenth]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -l tolerance -d 'Maximum distance of a position from its pose; greater than 0 [default: 1/1000 of the diagonal of the bounds of the positions]' -r
complete -c vides -n "__fish_vides_using_subcommand fit" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand fit" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand fit" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand set" -l keep -d 'What stays when the frame rate (fps) changes: the seconds at which things happen, or the frames, so that the film gets faster or slower' -r -f -a "seconds\t''
frames\t''"
complete -c vides -n "__fish_vides_using_subcommand set" -s o -l output -d 'The output file; - is standard output [default: FILE.vid]' -r -F
complete -c vides -n "__fish_vides_using_subcommand set" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand set" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand move" -l by -d 'By how much [default: 0,0,0]' -r
complete -c vides -n "__fish_vides_using_subcommand move" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand move" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand move" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand move" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand move" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand move" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand turn" -l axis -d 'The axis [default: y]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand turn" -l angle -d 'By which angle; -360000 to 360000 [default: 90]' -r
complete -c vides -n "__fish_vides_using_subcommand turn" -l about -d 'The fixed point: middle, origin, point, target, or X,Y,Z [default: middle]' -r
complete -c vides -n "__fish_vides_using_subcommand turn" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand turn" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand turn" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand turn" -l at -d 'The current point; 1 or more [default: the first]' -r
complete -c vides -n "__fish_vides_using_subcommand turn" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand turn" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand turn" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand scale" -l factor -d 'By which factor; -1000 to 1000 [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand scale" -l about -d 'The fixed point: middle, origin, point, target, or X,Y,Z [default: middle]' -r
complete -c vides -n "__fish_vides_using_subcommand scale" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand scale" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand scale" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand scale" -l at -d 'The current point; 1 or more [default: the first]' -r
complete -c vides -n "__fish_vides_using_subcommand scale" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand scale" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand scale" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand mirror" -l axis -d 'The axis [default: x]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand mirror" -l about -d 'The fixed point: middle, origin, point, target, or X,Y,Z [default: middle]' -r
complete -c vides -n "__fish_vides_using_subcommand mirror" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand mirror" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand mirror" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand mirror" -l at -d 'The current point; 1 or more [default: the first]' -r
complete -c vides -n "__fish_vides_using_subcommand mirror" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand mirror" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand mirror" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand taper" -l axis -d 'The axis [default: y]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand taper" -l r0 -d 'How wide it is at one end; -1000 to 1000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand taper" -l r1 -d 'How wide it is at the other; -1000 to 1000 [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand taper" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand taper" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand taper" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand taper" -l box -d 'The box: two opposite corners [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand taper" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand taper" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand taper" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand bulge" -l axis -d 'The axis [default: y]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand bulge" -l a -d 'How wide it is in the middle; -1000 to 1000 [default: 2]' -r
complete -c vides -n "__fish_vides_using_subcommand bulge" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand bulge" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand bulge" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand bulge" -l box -d 'The box: two opposite corners [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand bulge" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand bulge" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand bulge" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand twist" -l axis -d 'The axis [default: y]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand twist" -l angle -d 'By which angle; -360000 to 360000 [default: 90]' -r
complete -c vides -n "__fish_vides_using_subcommand twist" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand twist" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand twist" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand twist" -l box -d 'The box: two opposite corners [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand twist" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand twist" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand twist" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand bend" -l axis -d 'The axis [default: y]' -r -f -a "x\t''
y\t''
z\t''"
complete -c vides -n "__fish_vides_using_subcommand bend" -l angle -d 'By which angle; -360000 to 360000 [default: 90]' -r
complete -c vides -n "__fish_vides_using_subcommand bend" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand bend" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand bend" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand bend" -l box -d 'The box: two opposite corners [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand bend" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand bend" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand bend" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand free-form" -l lattice -d 'One of 4 × 4 × 4 squares, and where it is in the box: x,y,z of each, 192 numbers; -1 to 1 is the box [default: not deformed]' -r
complete -c vides -n "__fish_vides_using_subcommand free-form" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand free-form" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand free-form" -l with-targets -d 'What the cameras see moves with it' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand free-form" -l box -d 'The box: two opposite corners [default: the bounds of the points]' -r
complete -c vides -n "__fish_vides_using_subcommand free-form" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand free-form" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand free-form" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand extract" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand extract" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand extract" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand extract" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand extract" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand insert" -l fit -d 'How it is placed there [default: move]' -r -f -a "none\t''
move\t''
turn\t''
scale\t''"
complete -c vides -n "__fish_vides_using_subcommand insert" -l with-targets -d 'What the cameras see moves with it [default: yes]' -r -f -a "no\t''
yes\t''"
complete -c vides -n "__fish_vides_using_subcommand insert" -l at -d 'The current point; 1 or more [default: the last]' -r
complete -c vides -n "__fish_vides_using_subcommand insert" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand insert" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand insert" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand blend" -l weight -d 'How much of the other path; -1000 to 1000 [default: 0.5]' -r
complete -c vides -n "__fish_vides_using_subcommand blend" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand blend" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand blend" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand reverse" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand reverse" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand reverse" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand repeat" -l times -d 'How often; 1 to 100000 [default: 2]' -r
complete -c vides -n "__fish_vides_using_subcommand repeat" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand repeat" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand repeat" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand steady" -l period -d 'Cut-off period: motion of this period is halved, faster motion is removed; 0.001 to 600 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand steady" -l within -d 'Maximum distance any position may move; 0: no limit; 0 or more [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand steady" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand steady" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand steady" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand avoid" -l radius -d 'Radius of a sphere around the camera that keeps the clearance; 0 or more [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand avoid" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand avoid" -l clearance -d 'Least distance from the object; greater than 0 [default: as in the check]' -r
complete -c vides -n "__fish_vides_using_subcommand avoid" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand avoid" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand avoid" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand picture" -l margin -d 'The share to keep free at each side; 0 to 0.49 [default: 0.1]' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l what -d 'What keeps it there [default: zoom]' -r -f -a "zoom\t''
distance\t''
view\t''"
complete -c vides -n "__fish_vides_using_subcommand picture" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand picture" -l node -d 'Only this object of the scene' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l box -d 'A box instead of an object: two opposite corners' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -l limit -d 'Overrides a limit of the file, as in turning=90, lengths in those of the path; turning=off removes it' -r
complete -c vides -n "__fish_vides_using_subcommand picture" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand picture" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand picture" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand frames" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand frames" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand frames" -l frames -d 'The frames, including the first and the last; 1 to 100000000' -r
complete -c vides -n "__fish_vides_using_subcommand frames" -l seconds -d 'The duration instead of --frames; greater than 0' -r
complete -c vides -n "__fish_vides_using_subcommand frames" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand frames" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand frames" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand retime" -l seconds -d 'How long; 0: as short as the limits allow; 0 to 1000000 [default: 0]' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l first -d 'The first of the points; 1 to 100000 [default: 1]' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l last -d 'The last of the points; 1 to 100000 [default: the last of the path]' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -l limit -d 'Overrides a limit of the file, as in turning=90, lengths in those of the path; turning=off removes it' -r
complete -c vides -n "__fish_vides_using_subcommand retime" -s o -l output -d 'The output file; - is standard output' -r -F
complete -c vides -n "__fish_vides_using_subcommand retime" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand retime" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand info" -l json -d 'Prints one JSON object, with all digits'
complete -c vides -n "__fish_vides_using_subcommand info" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand info" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand get" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand get" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand check" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand check" -l limit -d 'Overrides a limit of the file, as in turning=90, lengths in those of the path; turning=off removes it' -r
complete -c vides -n "__fish_vides_using_subcommand check" -s o -l output -d 'The file that --fix writes' -r -F
complete -c vides -n "__fish_vides_using_subcommand check" -l fix -d 'Applies fixes while they help, writes the path to --output, and reports what was fixed and what remains'
complete -c vides -n "__fish_vides_using_subcommand check" -l json -d 'Prints the findings and notes as a JSON array'
complete -c vides -n "__fish_vides_using_subcommand check" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand check" -s h -l help -d 'Print help'
complete -c vides -n "__fish_vides_using_subcommand plot" -s o -l output -d 'The output file, .svg or .png; - is standard output, as SVG, which is also where it goes without this option, but not onto a terminal' -r -F
complete -c vides -n "__fish_vides_using_subcommand plot" -l object -d 'Replaces the path\'s object: a mesh (.obj, .ply, .stl, .gltf, .glb) or the object of a .vid file' -r -F
complete -c vides -n "__fish_vides_using_subcommand plot" -l dark -d 'Uses a dark background'
complete -c vides -n "__fish_vides_using_subcommand plot" -l trust -d 'Also reads meshes and buffers that an input file names outside its folder'
complete -c vides -n "__fish_vides_using_subcommand plot" -s h -l help -d 'Print help'
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
complete -c vides -n "__fish_vides_using_subcommand convert" -l interpolation -d 'A function of the type V_INTERPOLATE for the interpolation "host:NAME" of a scene\'s tracks' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l node -d 'The node of a scene that is written [default: the shown camera]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l clip -d 'The animation of a glTF file that is read [default: all that move different things]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l frames -d 'The frames that are written, first and last, as people count them [default: all]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l fps -d 'Frames per second of what is written, in the same time; of a file that has none when it is read' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l times -d 'frames: a pose for each frame; own: at the keys of the camera, for tum, euroc, osg, kitti and matrices [default: own where a list becomes a list, without --fps and --frames]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l start -d 'The time of the first pose in files of the formats tum, euroc and osg [default: that of a list that becomes a list, else 0]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l size -d 'Width and height of the picture in pixels [default: 1920x1080]' -r
complete -c vides -n "__fish_vides_using_subcommand convert" -l up -d 'The up axis of the file [default: as the format says]' -r
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
