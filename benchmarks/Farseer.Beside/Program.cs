using System;
using Farseer.Beside;

return Cli.Run(args, Console.Out, Console.Error);
