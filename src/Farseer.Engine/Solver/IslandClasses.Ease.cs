using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;

namespace Farseer.Engine.Solver;

/// <summary>Islands that take finer substeps from now on.</summary>
internal sealed unsafe partial class IslandClasses
{
    /// <summary>
    /// Lets an island that comes to its finer substeps rest as deep as it lies. Fine contacts are stiff: what the coarse ones sank in by,
    /// they would take back at once, each at its own pace r·s, which in a tower adds up to the speed of its top: of 40 boxes at rest the
    /// topmost, which had hopped, was thrown up by 1.1 m, came to rest, and was thrown up again. The feed-forward φ that holds a contact of
    /// the depth -s in balance follows from r·s + K·γ·(λ - φ) = 0; from there it goes to its share of the load at its own pace, and the
    /// depth with it. What lies no deeper than fine contacts do keeps its feed-forward. Only where there are so many levels that sweeps do
    /// not reach through them: others would only rise later, and where steps change in length, and an island is now fine and now is not,
    /// never.
    /// </summary>
    /// <param name="index">The class.</param>
    /// <param name="forecast">Tells which islands are new in their class.</param>
    /// <param name="islands">The islands of the rows.</param>
    /// <param name="c">The substep of the class.</param>
    public void Ease(int index, SagForecast forecast, IslandStore islands, in ContactCoefficients c)
    {
        if (!forecast.AnyRaised)
        {
            return;
        }

        float response = c.BiasRate / c.ImpulseScale;
        foreach (GraphColor color in Colors(index))
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int island = islands.OfSlot[row->Slot[lane]];
                    if (row->Contact[lane] >= 0 && forecast.IsRaised(island) && DeepStacks.IsHigh(islands, island))
                    {
                        Ease(&row->Point0, lane, response / row->K11[lane]);
                        Ease(&row->Point1, lane, response / row->K22[lane]);
                    }
                }
            }
        }
    }

    private static void Ease(ContactPointLanes* point, int lane, float response)
    {
        float depth = -DeepStacks.Separation(point, lane);
        if (depth > 0 && point->Normal[lane] > 0)
        {
            point->Feed[lane] = Math.Min(point->Feed[lane], point->Normal[lane] - (response * depth));
        }
    }
}
