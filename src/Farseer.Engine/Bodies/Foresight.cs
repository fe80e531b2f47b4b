using System;

namespace Farseer.Engine.Bodies;

/// <summary>
/// How far a body turns until the middle of the step, foreseen from its spin at the start. Contacts push at the arms that they have
/// there: with those of the start a body that tips over lags behind by half a step, an error that no number of substeps removes.
/// Within the step, turns are counted from the foreseen middle.
/// </summary>
internal static unsafe class Foresight
{
    /// <summary>A body that turns faster meets others anywhere; it is not foreseen further than this, radians.</summary>
    public const float LargestLead = 0.5f;

    // 1/n! of the series: up to the largest lead they are the functions to rounding.
    public const float SineThird = 1f / 6;
    public const float SineFifth = 1f / 120;
    public const float SineSeventh = 1f / 5040;
    public const float CosineFourth = 1f / 24;
    public const float CosineSixth = 1f / 720;
    public const float CosineEighth = 1f / 40320;

    /// <summary>Puts the bodies of the list half a step before their middle.</summary>
    public static void Begin(BodyStore bodies, int* list, int count, float dt)
    {
        BodyState* states = bodies.State.Pointer;
        BodyDrive* drives = bodies.Drive.Pointer;
        BodyMotion* motions = bodies.Motion.Pointer;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            BodyState* state = states + body;
            float lead = Math.Max(-LargestLead, Math.Min(LargestLead, 0.5f * dt * state->AngularVelocity));
            drives[body].Lead = lead;
            motions[body].Turned = -lead;
            float square = lead * lead;
            state->DeltaSin = -lead * (1 - (square * (SineThird - (square * (SineFifth - (square * SineSeventh))))));
            state->DeltaCos = 1 - (square * (0.5f - (square * (CosineFourth - (square * (CosineSixth - (square * CosineEighth)))))));
        }
    }
}
