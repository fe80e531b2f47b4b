using System;
using Farseer.Accuracy;

return Cli.Run(args, Console.Out, Console.Error);
