using System;
using System.Numerics;

Vector2 end = Lib.Scene.Throw(2);
Console.WriteLine(FormattableString.Invariant($"x {end.X:F3} y {end.Y:F3}"));
