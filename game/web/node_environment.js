// Programs for Node.js see the variables of the environment, such as ROPESWING_ASSETS.
Module['preRun'] = [() => Object.assign(ENV, process.env)];
