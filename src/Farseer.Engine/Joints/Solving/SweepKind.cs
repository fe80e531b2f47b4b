namespace Farseer.Engine.Joints.Solving;

/// <summary>What a sweep over the rows of trees is for.</summary>
internal enum SweepKind
{
    Biased,
    Relaxed,
    RelaxedSmooth,
    Impact,
    Settle,
    Correction,
    PushOut,
    Pull,
}
