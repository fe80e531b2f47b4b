using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary><see cref="Foresight"/> on lanes.</summary>
internal static class WideForesight
{
    /// <summary>Sine and cosine of the turn from the start of the step to its middle, for bodies with the given spin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Turn(Wide spin, float dt, out Wide sin, out Wide cos)
    {
        Wide lead = Wide.Max(Wide.Splat(-Foresight.LargestLead), Wide.Min(Wide.Splat(Foresight.LargestLead), Wide.Splat(0.5f * dt) * spin));
        Wide square = lead * lead;
        Wide one = Wide.One;
        sin = lead * (one - (square * (Wide.Splat(Foresight.SineThird)
            - (square * (Wide.Splat(Foresight.SineFifth) - (square * Wide.Splat(Foresight.SineSeventh)))))));
        cos = one - (square * (Wide.Splat(0.5f) - (square * (Wide.Splat(Foresight.CosineFourth)
            - (square * (Wide.Splat(Foresight.CosineSixth) - (square * Wide.Splat(Foresight.CosineEighth))))))));
    }
}
